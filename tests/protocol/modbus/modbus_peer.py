#!/usr/bin/python3
# A PLC of registers by pymodbus, with the addresses of resources/machines/modbus-example.toml: it multiplies and
# follows. `watched`: it restores 100 % when the heartbeat stops for 0.2 s; `retained`: nobody watches, and the overrides
# are kept over a restart. LOG gets a line for every override and control flag written.
# Usage: modbus_peer.py tcp PORT LOG watched|retained | rtu DEVICE LOG watched|retained
import asyncio
import sys
import time

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.server import StartAsyncSerialServer, StartAsyncTcpServer
from pymodbus.transaction import ModbusRtuFramer

KNOB, SPEED_WORD, FEED_WORD = 100, 8000, 600
written = {100: 1000, 101: 1000}
last_beat = 0.0
log = open(sys.argv[3], "a+", buffering=1)
watched = sys.argv[4] == "watched"
if not watched:
    log.seek(0)
    for what, value in (line.split() for line in log):
        if what != "control":
            written[int(what)] = int(value)


def forsaken():
    return watched and time.monotonic() - last_beat > 0.2


def factor(address):
    if forsaken():
        written[100] = written[101] = 1000
    return written[address] / 1000.0


class Holding(ModbusSequentialDataBlock):
    def getValues(self, address, count=1):
        values = {0: SPEED_WORD, 1: FEED_WORD, 2: KNOB, 3: round(KNOB * factor(100)), 100: round(1000 * factor(100)),
                  101: round(1000 * factor(101))}
        return [values.get(address + i, 0) for i in range(count)]

    def setValues(self, address, values):
        global last_beat
        for i, value in enumerate(values if isinstance(values, list) else [values]):
            if address + i == 102:
                last_beat = time.monotonic()
            else:
                if forsaken():
                    last_beat = time.monotonic()  # the first command of an engagement
                written[address + i] = value
                print(address + i, value, file=log)


class Coils(ModbusSequentialDataBlock):
    def setValues(self, address, values):
        print("control", int(values[0]), file=log)
        super().setValues(address, values)


class Inputs(ModbusSequentialDataBlock):
    def getValues(self, address, count=1):
        speed = round(10 * SPEED_WORD * KNOB / 100 * factor(100))
        values = {0: 1 << 4, 10: speed >> 16, 11: speed & 0xFFFF}
        return [values.get(address + i, 0) for i in range(count)]


block = ModbusSlaveContext(di=ModbusSequentialDataBlock(0, [0] * 256), co=Coils(0, [0] * 256),
                           hr=Holding(0, [0] * 256), ir=Inputs(0, [0] * 256), zero_mode=True)
context = ModbusServerContext(slaves={1: block}, single=False)
if sys.argv[1] == "tcp":
    asyncio.run(StartAsyncTcpServer(context=context, address=("127.0.0.1", int(sys.argv[2])),
                                     allow_reuse_address=True))
else:
    asyncio.run(StartAsyncSerialServer(context=context, framer=ModbusRtuFramer, port=sys.argv[2], baudrate=115200))
