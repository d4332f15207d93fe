// A list whose rows break their texts into as many lines as they need. Qt measures a row without the space that the
// style leaves at its sides, and so cuts off the last line of a text that just does not fit. GUI thread.
#pragma once

class QListView;

namespace stillcut::ui {

void showWrapped(QListView& list);
// The height that the text of `row` needs in its place.
int wrappedHeight(const QListView& list, int row);

}  // namespace stillcut::ui
