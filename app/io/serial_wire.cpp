#include "app/io/serial_wire.h"

#include <QEventLoop>
#include <QSerialPort>
#include <QThread>
#include <algorithm>
#include <thread>
#include <utility>

namespace stillcut::app {

using cnc::WireState;

namespace {

constexpr qint64 kMostHeld = 1 << 16;  // a peer may send without end

QSerialPort::Parity parityOf(char letter) {
  if (letter == 'N') return QSerialPort::NoParity;
  return letter == 'O' ? QSerialPort::OddParity : QSerialPort::EvenParity;
}

}  // namespace

SerialWire::SerialWire(std::string device, int baud, char parity, int stopBits)
    : device_(std::move(device)), baud_(baud), parity_(parity), stopBits_(stopBits) {}

SerialWire::~SerialWire() {
  SerialWire::close();  // handed over and never taken, it belongs to no thread
}

void SerialWire::connect() noexcept {
  close();
  QEventLoop dispatcher;  // gives a thread that Qt did not start what the port's notifiers need
  port_ = std::make_unique<QSerialPort>(QString::fromStdString(device_));
  port_->setBaudRate(baud_);
  port_->setParity(parityOf(parity_));
  port_->setStopBits(stopBits_ == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop);
  port_->setReadBufferSize(kMostHeld);
  if (!port_->open(QIODevice::ReadWrite)) port_.reset();
}

bool SerialWire::broken() const noexcept {
  const auto error = port_->error();
  return error == QSerialPort::ResourceError || error == QSerialPort::ReadError || error == QSerialPort::WriteError ||
         error == QSerialPort::DeviceNotFoundError;
}

void SerialWire::handOver() noexcept {
  if (port_) port_->moveToThread(nullptr);
}

// After handOver(): the port belongs to no thread, and this one takes it.
void SerialWire::adopt() noexcept {
  if (!port_ || port_->thread() != nullptr) return;
  QEventLoop dispatcher;
  port_->moveToThread(QThread::currentThread());
}

WireState SerialWire::state() noexcept {
  adopt();
  if (port_ && broken()) close();
  return port_ ? WireState::Open : WireState::Closed;
}

std::size_t SerialWire::read(std::span<char> into) noexcept {
  if (state() != WireState::Open) return 0;
  if (port_->bytesAvailable() == 0) port_->waitForReadyRead(0);
  const qint64 n = port_->read(into.data(), static_cast<qint64>(into.size()));
  if (n < 0 || broken()) close();
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

bool SerialWire::write(std::string_view bytes) noexcept {
  if (state() != WireState::Open) return false;
  const bool taken = port_->write(bytes.data(), static_cast<qint64>(bytes.size())) == static_cast<qint64>(bytes.size());
  // The queue goes out at once: nothing on this thread would send it later.
  if (taken && (port_->bytesToWrite() == 0 || port_->waitForBytesWritten(20)) && !broken()) return true;
  close();
  return false;
}

void SerialWire::wait(Duration atMost) noexcept {
  adopt();
  if (port_) {
    port_->waitForReadyRead(std::max(1, static_cast<int>(atMost.count() / 1'000'000)));
  } else {
    std::this_thread::sleep_for(atMost);
  }
}

void SerialWire::close() noexcept {
  adopt();
  port_.reset();
}

}  // namespace stillcut::app
