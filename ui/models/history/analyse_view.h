// What the plots of the Analyse page share: the stretch of time and of frequency on show, the cursors, and how things
// are drawn. Every way of moving (wheel, drag, key, number) ends here. GUI thread.
#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "core/base/time.h"

namespace stillcut::ui {

enum class SpectrogramForm { HeatMap, Waterfall };
enum class LevelScale { Decibel, Linear };
enum class FrequencyAxis { Hertz, Order };

// What a preset keeps.
struct AnalyseOptions {
  SpectrogramForm form = SpectrogramForm::HeatMap;
  LevelScale level = LevelScale::Decibel;
  FrequencyAxis axis = FrequencyAxis::Hertz;
  bool maxHold = false;
  bool events = false;  // what happened and the machine's numbers, in the place of spectrum and signal
  int channel = 0;
  Seconds span{10.0};
  Hertz low{}, high{5000.0};
  bool operator==(const AnalyseOptions&) const = default;
};

class AnalyseView : public QObject {
  Q_OBJECT
 public:
  static constexpr Seconds kShortest{0.02};
  static constexpr Hertz kNarrowest{100.0};

  explicit AnalyseView(QObject* parent = nullptr);

  const AnalyseOptions& options() const { return options_; }
  // Values out of range are brought into it.
  void setOptions(const AnalyseOptions& options);

  // What there is to see, at every tick. A picture that follows moves along.
  void setReach(Instant first, Instant newest, Hertz top);
  // The same of a recording that is complete: all of it is shown, a picture that follows shows all, and any stretch of
  // it can be shown at once.
  void setWhole(Seconds length, Hertz top);
  // It has become longer or shorter, as of a second one beside it: what shows all of it goes on to, and else the
  // stretch on show stays, as far as there is any.
  void setLength(Seconds length);
  Instant first() const { return first_; }
  Instant newest() const { return newest_; }
  Hertz top() const { return top_; }

  bool following() const { return following_; }
  void follow();
  Instant to() const { return following_ ? newest_ : to_; }
  Instant from() const { return to() - toDuration(options_.span); }
  // Shows `t` in the middle and stands still.
  void goTo(Instant t);
  void pan(Seconds by);
  // Keeps `around` where it is.
  void zoomTime(double factor, Instant around);
  void showTimes(Instant from, Instant to);
  void panFrequency(Hertz by);
  void zoomFrequency(double factor, Hertz around);
  void showFrequencies(Hertz low, Hertz high);

  // Two cursors in time; they stay where they were put while the picture moves.
  enum Cursor { A, B };
  std::optional<Instant> cursor(Cursor c) const { return cursors_[c]; }
  void setCursor(Cursor c, std::optional<Instant> t);
  // The frequency whose harmonics are marked.
  std::optional<Hertz> harmonic() const { return harmonic_; }
  void setHarmonic(std::optional<Hertz> f);

  // Another run: nothing of the old one is left but the options.
  void restart();

 signals:
  void changed();

 private:
  void stand();

  AnalyseOptions options_;
  Instant first_{}, newest_{}, to_{};
  Hertz top_{};
  Seconds longest_;  // stretch that can be shown
  bool whole_ = false;
  bool following_ = true;
  std::array<std::optional<Instant>, 2> cursors_;
  std::optional<Hertz> harmonic_;
};

}  // namespace stillcut::ui
