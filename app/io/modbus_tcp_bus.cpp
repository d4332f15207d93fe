#include "app/io/modbus_tcp_bus.h"

#include <QEventLoop>
#include <QModbusTcpClient>
#include <QTimer>
#include <QVariant>
#include <algorithm>
#include <utility>

namespace stillcut::app {

using cnc::RegisterTable;
using cnc::WireState;

namespace {

QModbusDataUnit::RegisterType typeOf(RegisterTable table) {
  switch (table) {
    case RegisterTable::Coil:
      return QModbusDataUnit::Coils;
    case RegisterTable::Discrete:
      return QModbusDataUnit::DiscreteInputs;
    case RegisterTable::Input:
      return QModbusDataUnit::InputRegisters;
    case RegisterTable::Holding:
      break;
  }
  return QModbusDataUnit::HoldingRegisters;
}

}  // namespace

ModbusTcpBus::ModbusTcpBus(cnc::BusAddress address) : address_(std::move(address)) {
  const cnc::WireAddress& w = address_.wire;
  name_ = w.host + ":" + std::to_string(w.port) + " unit " + std::to_string(address_.unit);
}

ModbusTcpBus::~ModbusTcpBus() = default;

void ModbusTcpBus::connect() noexcept {
  close();
  const QEventLoop dispatcher;  // gives a thread that Qt did not start what the client's notifiers need
  const cnc::WireAddress& w = address_.wire;
  client_ = std::make_unique<QModbusTcpClient>();
  client_->setConnectionParameter(QModbusDevice::NetworkAddressParameter, QString::fromStdString(w.host));
  client_->setConnectionParameter(QModbusDevice::NetworkPortParameter, w.port);
  client_->setTimeout(std::max(10, static_cast<int>(address_.answerWithin.value * 1e3)));
  client_->setNumberOfRetries(0);
  if (!client_->connectDevice()) client_.reset();
}

void ModbusTcpBus::turnEvents(int milliseconds) const noexcept {
  QEventLoop loop;
  if (milliseconds <= 0) {
    loop.processEvents();
    return;
  }
  // With a time limit Qt does not wait for events but looks and comes back at once; a timer of ours is one to wait for.
  QTimer end;
  end.setSingleShot(true);
  end.setTimerType(Qt::PreciseTimer);
  end.start(milliseconds);
  while (end.isActive() && !finished()) loop.processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
}

WireState ModbusTcpBus::state() noexcept {
  if (!client_) return WireState::Closed;
  turnEvents(0);
  switch (client_->state()) {
    case QModbusDevice::ConnectedState:
      return WireState::Open;
    case QModbusDevice::ConnectingState:
      return WireState::Opening;
    default:
      close();
      return WireState::Closed;
  }
}

bool ModbusTcpBus::read(RegisterTable table, int first, int count) noexcept {
  if (!client_ || reply_) return false;
  reply_.reset(client_->sendReadRequest({typeOf(table), first, static_cast<quint16>(count)}, address_.unit));
  return reply_ != nullptr;
}

bool ModbusTcpBus::write(RegisterTable table, int first, int count, const cnc::RegisterWords& words) noexcept {
  if (!client_ || reply_) return false;
  QModbusDataUnit unit(typeOf(table), first, static_cast<quint16>(count));
  for (int i = 0; i < count; ++i) unit.setValue(i, words[static_cast<std::size_t>(i)]);
  reply_.reset(client_->sendWriteRequest(unit, address_.unit));
  return reply_ != nullptr;
}

bool ModbusTcpBus::finished() const noexcept {
  return reply_ && reply_->isFinished();
}

std::optional<cnc::BusReply> ModbusTcpBus::take() noexcept {
  if (!reply_) return std::nullopt;
  if (!finished()) turnEvents(0);
  if (!finished()) return std::nullopt;
  cnc::BusReply out;
  out.ok = reply_->error() == QModbusDevice::NoError;
  const QModbusDataUnit unit = reply_->result();
  for (std::size_t i = 0; i < out.words.size() && i < static_cast<std::size_t>(unit.valueCount()); ++i) {
    out.words[i] = unit.value(static_cast<qsizetype>(i));
  }
  reply_.reset();
  return out;
}

void ModbusTcpBus::wait(Duration atMost) noexcept {
  turnEvents(std::max(1, static_cast<int>(atMost.count() / 1'000'000)));
}

void ModbusTcpBus::close() noexcept {
  reply_.reset();
  if (client_) client_->disconnectDevice();
  client_.reset();
}

}  // namespace stillcut::app
