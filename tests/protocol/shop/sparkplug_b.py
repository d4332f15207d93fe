#!/usr/bin/env python3
"""An independent reader and writer of Sparkplug B for the tests: Google's Protocol Buffers, with the messages as the
specification (Eclipse Sparkplug 3.0, sparkplug_b.proto, the fields used here) numbers them.

    sparkplug_b.py decode      hexadecimal payloads, one a line, to JSON lines
    sparkplug_b.py rebirth     the request for a new birth, in hexadecimal
"""
import json
import sys

try:
    from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
except ImportError:
    print("python3-protobuf is not installed", file=sys.stderr)
    sys.exit(77)

FIELD = descriptor_pb2.FieldDescriptorProto
METRIC = [("name", 1, FIELD.TYPE_STRING), ("alias", 2, FIELD.TYPE_UINT64), ("timestamp", 3, FIELD.TYPE_UINT64),
          ("datatype", 4, FIELD.TYPE_UINT32), ("is_historical", 5, FIELD.TYPE_BOOL), ("is_transient", 6, FIELD.TYPE_BOOL),
          ("is_null", 7, FIELD.TYPE_BOOL), ("int_value", 10, FIELD.TYPE_UINT32), ("long_value", 11, FIELD.TYPE_UINT64),
          ("float_value", 12, FIELD.TYPE_FLOAT), ("double_value", 13, FIELD.TYPE_DOUBLE),
          ("boolean_value", 14, FIELD.TYPE_BOOL), ("string_value", 15, FIELD.TYPE_STRING)]
PAYLOAD = [("timestamp", 1, FIELD.TYPE_UINT64), ("metrics", 2, FIELD.TYPE_MESSAGE), ("seq", 3, FIELD.TYPE_UINT64),
           ("uuid", 4, FIELD.TYPE_STRING), ("body", 5, FIELD.TYPE_BYTES)]


def payload_class():
    file = descriptor_pb2.FileDescriptorProto(name="sparkplug_b.proto", package="p", syntax="proto2")
    for name, fields in (("Metric", METRIC), ("Payload", PAYLOAD)):
        message = file.message_type.add(name=name)
        for field, number, kind in fields:
            message.field.add(name=field, number=number, type=kind,
                              label=FIELD.LABEL_REPEATED if field == "metrics" else FIELD.LABEL_OPTIONAL,
                              type_name=".p.Metric" if field == "metrics" else None)
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    return message_factory.MessageFactory(pool).GetPrototype(pool.FindMessageTypeByName("p.Payload"))


def main():
    payload_type = payload_class()
    if sys.argv[1] == "rebirth":
        request = payload_type(timestamp=1)
        request.metrics.add(name="Node Control/Rebirth", timestamp=1, datatype=11, boolean_value=True)
        print(request.SerializeToString().hex())
        return
    for line in sys.stdin:
        payload = payload_type.FromString(bytes.fromhex(line.strip()))
        known = {field.name for field, _ in payload.ListFields()}
        metrics = [{field.name: value for field, value in metric.ListFields()} for metric in payload.metrics]
        # Nothing that the specification does not have.
        assert not payload.UnknownFields() and not any(m.UnknownFields() for m in payload.metrics), line
        print(json.dumps({"timestamp": payload.timestamp, "seq": payload.seq if "seq" in known else None, "metrics": metrics}))


if __name__ == "__main__":
    main()
