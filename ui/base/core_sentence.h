// Sentences core puts together from words and values ("column 'Fx' holds nan"), in the reader's language. Any thread.
#pragma once

#include <QString>
#include <string>

namespace stillcut::ui {

// By the table translations/core_sentences.h, which a script makes from the sources: the sentence is found again,
// translated, and its values put back; values that are sentences or words of core are translated too. What is in no
// table, as the name of a file, stays as it is. For what is told now and then, not at every frame.
QString coreSentence(const std::string& english);

}  // namespace stillcut::ui
