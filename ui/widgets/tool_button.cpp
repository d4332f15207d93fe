#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

TouchButton* makeToolButton(const QString& caption, const QString& spoken, QAnyStringView name) {
  auto* made = new TouchButton(caption);
  made->setObjectName(name);
  made->setAccessibleName(spoken);
  made->setBaseHeight(50);
  return made;
}

}  // namespace stillcut::ui
