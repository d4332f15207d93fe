// A cut entered by hand, for the screens' tests: what was entered is kept, and computed by fake lobes.
#pragma once

#include <optional>

#include "tests/ui/support/fake_lobes.h"
#include "ui/facade/lobe_entry.h"

namespace stillcut::ui {

class FakeLobeEntry final : public LobeEntryController {
 public:
  FakeLobeEntry() {
    materials_ = {{QStringLiteral("7075-T6"), QStringLiteral("Aluminium, wrought"), 7.96e8, 1.69e8},
                  {QStringLiteral("Ti-6Al-4V"), QStringLiteral("Titanium alloy"), 0.0, 0.0}};
    lobes_.mutableFrame().name = QStringLiteral("entered");
  }
  const std::vector<EnteredMaterial>& materials() const override { return materials_; }
  Result<EnteredCut> read(const EnteredCut& cut, const QString& file) const override {
    if (!ofFile) return Error{file.toStdString(), message("cannot be opened")};
    EnteredCut read = *ofFile;
    read.file = file;
    read.feedPerTooth = cut.feedPerTooth;
    return read;
  }
  Status enter(const EnteredCut& cut) override {
    if (cut.modes.empty() || !(cut.modes.front().frequency.value > 0.0))
      return Error{message("modes"), message("none is entered")};
    entered = cut;
    return Done{};
  }
  LobeService* service() override { return entered ? &lobes_ : nullptr; }

  std::optional<EnteredCut> ofFile, entered;
  FakeLobes& fakeLobes() { return lobes_; }

 private:
  std::vector<EnteredMaterial> materials_;
  FakeLobes lobes_;
};

}  // namespace stillcut::ui
