// RememberingLink: a link whose orders are on record while they stand in the machine. At the next connection, what an
// earlier program has left is told from the operator's own: where the machine still stands as it was left, that is
// offered back, and a Release, which the gate gives when the operator asks for 100 %, brings back what the operator had
// then. Until then nothing is sent; a hand on the knob, or a new engagement, ends the offer.
// Thread: that of CncLink; the offer's cell: any.
#pragma once

#include <memory>
#include <optional>

#include "core/cnc/cnc_link.h"
#include "core/cnc/override_memory.h"

namespace stillcut::cnc {

class RememberingLink final : public CncLink {
 public:
  // `offered`: what was left and can be brought back, where base and sent differ; nothing: there is no offer.
  RememberingLink(std::unique_ptr<CncLink> link, std::unique_ptr<OverrideMemory> memory,
                  std::shared_ptr<SentOverridesCell> offered);

  LinkInfo describe() const override { return link_->describe(); }
  Status open() override { return link_->open(); }
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override { link_->adopt(speed, feed); }
  void close() noexcept override { link_->close(); }

 private:
  void compare(const MachineState& m) noexcept;
  void watchHome(const MachineState& m) noexcept;
  void endOffer() noexcept;

  std::unique_ptr<CncLink> link_;
  std::unique_ptr<OverrideMemory> memory_;
  std::shared_ptr<SentOverridesCell> offered_;
  std::optional<SentOverrides> left_;      // until it is home, or somebody else's hand was seen
  std::optional<SentOverrides> onRecord_;  // of this program
  bool goingHome_ = false;                 // what was left: asked for
  bool inForce_ = false;
  Ratio baseSpeed_{1.0}, baseFeed_{1.0};  // as last read
};

}  // namespace stillcut::cnc
