#include "core/active/pcm_duplex.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillcut::active {

namespace {

constexpr double kFullScale = 2147483648.0;
constexpr double kLargest = 2147483647.0;

}  // namespace

PcmDuplex::PcmDuplex(PcmDuplexSettings settings, std::unique_ptr<PcmDuplexDriver> driver)
    : settings_(std::move(settings)), driver_(std::move(driver)) {
  settings_.request.inputs = std::ranges::max(settings_.input) + 1;
  settings_.request.outputs = std::ranges::max(settings_.output) + 1;
}

Result<DuplexFormat> PcmDuplex::open() {
  for (std::size_t a = 0; a < 2; ++a) {
    const auto scale = [](double v) { return std::isfinite(v) && v != 0.0; };
    if (!scale(settings_.sensor[a]) || !scale(settings_.stroke[a])) {
      return Error{settings_.request.device, message("what full scale means must be a number other than 0")};
    }
  }
  auto opened = driver_->open(settings_.request);
  if (!opened) return opened.error();
  format_ = *opened;
  in_.assign(static_cast<std::size_t>(format_.frames * format_.inputs), 0);
  out_.assign(static_cast<std::size_t>(format_.frames * format_.outputs), 0);
  stopped_.store(false, std::memory_order_relaxed);
  return DuplexFormat{settings_.request.rate, format_.frames, format_.together};
}

DuplexEvent PcmDuplex::after(int fault) STILLCUT_RT {
  if (fault == 0) return DuplexEvent::Block;
  if (fault == kDuplexLost && driver_->restart()) return DuplexEvent::Lost;
  driver_->close();  // what is queued is not played
  return DuplexEvent::Gone;
}

DuplexEvent PcmDuplex::read(std::span<double> in) STILLCUT_RT {
  if (stopped_.load(std::memory_order_relaxed)) return DuplexEvent::Gone;
  const DuplexEvent event = after(driver_->read(in_.data()));
  if (event != DuplexEvent::Block) return event;
  const auto frames = static_cast<std::size_t>(format_.frames);
  const auto stride = static_cast<std::size_t>(format_.inputs);
  for (std::size_t a = 0; a < 2; ++a) {
    const std::int32_t* from = in_.data() + settings_.input[a];
    const double scale = settings_.sensor[a] / kFullScale;
    for (std::size_t f = 0; f < frames; ++f) in[a * frames + f] = scale * from[f * stride];
  }
  return event;
}

DuplexEvent PcmDuplex::write(std::span<const safety::ActuatorCommand> out) STILLCUT_RT {
  const auto frames = static_cast<std::size_t>(format_.frames);
  const auto stride = static_cast<std::size_t>(format_.outputs);
  for (std::size_t a = 0; a < 2; ++a) {
    std::int32_t* to = out_.data() + settings_.output[a];
    const double scale = kFullScale / settings_.stroke[a];
    for (std::size_t f = 0; f < frames; ++f) {
      to[f * stride] = static_cast<std::int32_t>(std::clamp(scale * out[a * frames + f].value(), -kLargest, kLargest));
    }
  }
  return after(driver_->write(out_.data()));
}

}  // namespace stillcut::active
