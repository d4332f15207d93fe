// The fields of a cut that is entered by hand on the Lobes page: tool, material, engagement, speeds, and a table of
// modes. GUI thread.
#pragma once

#include <array>
#include <vector>

#include "ui/base/units.h"
#include "ui/facade/lobe_entry.h"
#include "ui/widgets/panel.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSettings;
class QTableWidget;

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class CutForm : public Panel {
  Q_OBJECT
 public:
  // `entry` outlives the form.
  explicit CutForm(LobeEntryController& entry, QWidget* parent = nullptr);

  EnteredCut cut() const;
  void fill(const EnteredCut& cut);
  void setUnits(UnitSystem units);
  // Of a cut that was entered before the program ended.
  void keep(QSettings& settings) const;
  void restore(const QSettings& settings);
  // What the file says takes the place of what stands in the fields.
  void openFile(const QString& path);

  void applyTheme(const Theme& theme) override;

 signals:
  void entered();       // taken over: service() is of it
  void stateChanged();  // what keep() writes

 private:
  QDoubleSpinBox* makeNumber(const QString& label, const char* name, int decimals, double least, double most,
                             const QString& suffix);
  QComboBox* makeChoice(const QString& label, const char* name);
  void place(const QString& label, QWidget* field);
  void makeTable();
  void fillMaterials();
  void browse();
  void enter();
  void addMode();
  void removeMode();
  void appendRow(const std::array<QString, 4>& texts);
  void takeMaterial();
  void setLengthRanges();
  void tell(const QString& text, Tone tone);

  LobeEntryController& entry_;
  UnitSystem units_ = UnitSystem::Metric;
  EnteredCut begun_;  // what the fields do not show of it
  std::vector<QWidget*> fields_;
  std::vector<QBoxLayout*> lines_;
  QGridLayout* grid_;
  QComboBox *material_, *side_;
  QDoubleSpinBox *tangential_, *radial_, *teeth_, *diameter_, *helix_, *width_, *feed_, *depth_, *deepest_, *lowest_,
      *highest_;
  QTableWidget* modes_;
  TextLabel *file_, *said_;
  TouchButton *open_, *add_, *remove_, *enter_;
};

}  // namespace stillcut::ui
