// EnteredCutLobes: the lobes of a cut that was entered by hand or read from any file that describes one, beside
// whatever runs. Thread: GUI; lobes are computed apart.
#pragma once

#include <memory>
#include <vector>

#include "app/compose/cut/cut_file.h"
#include "app/session/lobe_worker.h"
#include "ui/facade/lobe_entry.h"

namespace stillcut::app {

class EnteredCutLobes final : public ui::LobeEntryController {
 public:
  EnteredCutLobes();

  const std::vector<ui::EnteredMaterial>& materials() const override { return materials_; }
  Result<ui::EnteredCut> read(const ui::EnteredCut& cut, const QString& file) const override;
  Status enter(const ui::EnteredCut& cut) override;
  ui::LobeService* service() override { return lobes_.get(); }

 private:
  std::vector<ui::EnteredMaterial> materials_;
  std::unique_ptr<LobeWorker> lobes_;
};

}  // namespace stillcut::app
