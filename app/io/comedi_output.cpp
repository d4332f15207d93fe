#include "app/io/comedi_output.h"

#ifdef STILLCUT_COMEDI
#include <comedilib.h>
#endif
#include <utility>

#include "core/cnc/analog/silent_output.h"

namespace stillcut::app {

#ifdef STILLCUT_COMEDI
namespace {

class ComediOutput final : public cnc::AnalogOutput {
 public:
  ~ComediOutput() override {
    if (device_ != nullptr) ::comedi_close(device_);
  }
  ComediOutput() = default;
  ComediOutput(const ComediOutput&) = delete;
  ComediOutput& operator=(const ComediOutput&) = delete;

  Status open(const cnc::AnalogDevice& device) override {
    settings_ = device;
    device_ = ::comedi_open(device.file.c_str());
    if (device_ == nullptr)
      return Error{device.file, message("cannot be opened"), foreign(::comedi_strerror(::comedi_errno()))};
    const auto subdevice = static_cast<unsigned>(device.subdevice);
    if (::comedi_get_subdevice_type(device_, subdevice) != COMEDI_SUBD_AO) {
      return Error{device.file, message("subdevice %1 is no analog output", std::to_string(device.subdevice)),
                   message("set [device] subdevice")};
    }
    return Done{};
  }
  bool write(int channel, double volts) noexcept override {
    if (device_ == nullptr) return false;
    const auto subdevice = static_cast<unsigned>(settings_.subdevice);
    const auto line = static_cast<unsigned>(channel);
    const auto range = static_cast<unsigned>(settings_.range);
    ::comedi_range* span = ::comedi_get_range(device_, subdevice, line, range);
    const lsampl_t most = ::comedi_get_maxdata(device_, subdevice, line);
    if (span == nullptr || most == 0 || volts < span->min || volts > span->max) return false;
    return ::comedi_data_write(device_, subdevice, line, range, AREF_GROUND, ::comedi_from_phys(volts, span, most)) ==
           1;
  }

 private:
  comedi_t* device_ = nullptr;
  cnc::AnalogDevice settings_;
};

}  // namespace

std::unique_ptr<cnc::AnalogOutput> makeComediOutput() {
  return std::make_unique<ComediOutput>();
}
#else
std::unique_ptr<cnc::AnalogOutput> makeComediOutput() {
  return nullptr;
}
#endif

std::unique_ptr<cnc::AnalogOutput> makeSilentOutput() {
  auto card = makeComediOutput();
  return card ? std::make_unique<cnc::SilentOutput>(std::move(card)) : nullptr;
}

}  // namespace stillcut::app
