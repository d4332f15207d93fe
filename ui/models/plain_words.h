// Sentences of parts that are made for profiles, in the words of the screen: no key of a file is shown. GUI thread,
// pure.
#pragma once

#include <QString>

namespace stillcut::ui {

// "An audio device: device, rate_hz, inputs" is "An audio device": the form below asks for the rest by its own labels.
QString withoutKeys(const QString& description);

// "rate_hz is missing", "0 [[channels]] in the profile": keys by their labels, tables by their names.
QString plainWords(const QString& sentence);

// A kind of device on its button: "AUDIO"; one that has no word of its own by its id.
QString sourceCaption(const QString& id);

}  // namespace stillcut::ui
