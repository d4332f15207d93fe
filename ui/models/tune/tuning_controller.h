// TuningController: the values a person has set on a running cut or a replay: two sides, A and B, to compare, and what
// each did; every change can be undone; what has to reach the worker is handed out a few at a time. Lives as long as
// the run, whatever is on the screen. Knows no widget. GUI thread.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "core/config/param_set.h"
#include "core/model/operator_input.h"
#include "ui/models/tune/compare_tally.h"

namespace stillcut::ui {

class TuningController : public QObject {
  Q_OBJECT
 public:
  enum Side { A = 0, B = 1 };
  using QObject::QObject;

  // Another run: both sides begin with its values, nothing can be undone.
  void open(const config::ParamSet& started);
  // The same run was begun anew with the values it started with: it is told again what was set.
  void resend();

  double value(const config::ParamDecl& decl) const { return value(decl, side_); }
  double value(const config::ParamDecl& decl, Side side) const { return sides_[side].real(decl); }
  const config::ParamSet& values() const { return sides_[side_]; }
  // Of the side in use. Values that are not legal are ignored. Moves of one slider are one step until settle().
  void set(const config::ParamDecl& decl, double value);
  void settle() { ++gesture_; }
  // Several values at once, one step of undo; those that are not legal are ignored.
  void setTogether(const std::vector<std::pair<const config::ParamDecl*, double>>& values, const QString& text);
  // Several at once, one step of undo: to the defaults, or to what the run began with.
  void resetToDefaults(const std::vector<const config::ParamDecl*>& decls);
  void resetToStart(const std::vector<const config::ParamDecl*>& decls);

  Side side() const { return side_; }
  void use(Side side);
  // The other side becomes like the one in use.
  void copyToOther();
  // Parameters in which the sides differ.
  std::vector<std::string> differences() const;

  CompareTally& tally() { return tally_; }
  QUndoStack& undoStack() { return undo_; }
  // What the worker does not know yet, oldest first, at most `most` of them.
  std::vector<OperatorInput> take(int most);
  bool pending() const { return !queue_.empty(); }

 signals:
  void changed();

 private:
  friend class SetValues;
  struct Change {
    const config::ParamDecl* decl;
    double before, after;
  };
  void push(std::vector<Change> changes, const QString& text);
  void apply(Side side, const config::ParamDecl& decl, double value);
  void enqueue(const config::ParamDecl& decl, double value);

  std::array<config::ParamSet, 2> sides_;
  config::ParamSet started_;
  std::map<std::string, const config::ParamDecl*, std::less<>> seen_;  // every parameter ever set
  Side side_ = A;
  int gesture_ = 0;
  std::deque<OperatorInput> queue_;
  CompareTally tally_;
  QUndoStack undo_;
};

}  // namespace stillcut::ui
