#include "core/milling/identify/modal_measurement.h"

#include <utility>

namespace stillcut::identify {

Result<ModalAnswer> identifyModes(const std::string& path, const ModalRequest& request) {
  auto measured = importMeasurement(path, request.import);
  if (!measured) return measured.error();
  ModalAnswer answer;
  answer.remarks = std::move(measured->remarks);
  const auto remark = [&](const std::vector<std::string>& lines) {
    answer.remarks.insert(answer.remarks.end(), lines.begin(), lines.end());
  };
  Frf frf;
  if (const auto* record = std::get_if<HammerRecord>(&measured->data)) {
    auto analysed = analyseHammer(*record, request.hammer);
    if (!analysed) return analysed.error();
    answer.fromHammer = true;
    answer.hits = std::move(analysed->hits);
    remark(analysed->remarks);
    frf = std::move(analysed->frf);
  } else {
    frf = std::move(std::get<Frf>(measured->data));
    if (request.hammer.flipResponse) {
      for (auto& v : frf.value) v = -v;
    }
  }
  auto fit = fitModes(frf, request.fit);
  if (!fit) return fit.error();
  remark(fit->remarks);
  answer.fit = std::move(*fit);
  return answer;
}

}  // namespace stillcut::identify
