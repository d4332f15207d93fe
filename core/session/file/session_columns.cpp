// The tables of a session file, column by column, as resources/manual/files.md describes them.
#include "core/session/file/session_rows.h"

namespace stillcut::record {
namespace {

using T = FieldType;

constexpr std::size_t kReasonCode = offsetof(ReasonRow, code);
constexpr std::size_t kReasonNumbers = offsetof(ReasonRow, n);

}  // namespace

template <>
std::span<const RowField> columnsOf<BlockRow>() {
  static constexpr std::array<RowField, 8> kColumns{{{"sequence", offsetof(BlockRow, sequence), T::U64},
                                                     {"first_sample_ns", offsetof(BlockRow, firstSample), T::I64},
                                                     {"rate_hz", offsetof(BlockRow, rate), T::F64},
                                                     {"lost_frames", offsetof(BlockRow, lostFrames), T::U64},
                                                     {"offset", offsetof(BlockRow, offset), T::U64},
                                                     {"source", offsetof(BlockRow, source), T::U32},
                                                     {"frames", offsetof(BlockRow, frames), T::I32},
                                                     {"flags", offsetof(BlockRow, flags), T::U32}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<MachineRow>() {
  static constexpr std::array<RowField, 26> kColumns{
      {{"time_ns", offsetof(MachineRow, time), T::I64},
       {"valid", offsetof(MachineRow, valid), T::U8},
       {"link_up", offsetof(MachineRow, linkUp), T::U8},
       {"program_running", offsetof(MachineRow, programRunning), T::U8},
       {"feed_hold", offsetof(MachineRow, feedHold), T::U8},
       {"at_speed", offsetof(MachineRow, atSpeed), T::U8},
       {"overrides_enabled", offsetof(MachineRow, overridesEnabled), T::U8},
       {"control_ours", offsetof(MachineRow, controlOurs), T::U8},
       {"programmed_speed_rpm", offsetof(MachineRow, programmedSpeed), T::F64},
       {"programmed_feed_m_s", offsetof(MachineRow, programmedFeed), T::F64},
       {"operator_speed", offsetof(MachineRow, operatorSpeed), T::F64},
       {"operator_feed", offsetof(MachineRow, operatorFeed), T::F64},
       {"speed_override", offsetof(MachineRow, speedOverride), T::F64},
       {"feed_override", offsetof(MachineRow, feedOverride), T::F64},
       {"actual_speed_rpm", offsetof(MachineRow, actualSpeed), T::F64},
       {"actual_feed_m_s", offsetof(MachineRow, actualFeed), T::F64},
       {"ended_engagement", offsetof(MachineRow, endedEngagement), T::U64},
       {"ordered_ns", offsetof(MachineRow, commanded), T::I64, 1, true},
       {"acknowledged_ns", offsetof(MachineRow, acknowledged), T::I64, 1, true},
       {"overrides_read_ns", offsetof(MachineRow, overridesRead), T::I64, 1, true},
       {"speed_read_ns", offsetof(MachineRow, speedRead), T::I64, 1, true},
       {"feed_read_ns", offsetof(MachineRow, feedRead), T::I64, 1, true},
       {"program_read_ns", offsetof(MachineRow, programRead), T::I64, 1, true},
       {"round_trip_s", offsetof(MachineRow, roundTrip), T::F64, 1, true},
       {"effect_delay_s", offsetof(MachineRow, effectDelay), T::F64, 1, true},
       {"block", offsetof(MachineRow, block), T::U8, 1, true}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<DecisionRow>() {
  static constexpr std::array<RowField, 10> kColumns{
      {{"time_ns", offsetof(DecisionRow, time), T::I64},
       {"kind", offsetof(DecisionRow, kind), T::U8},
       {"claims_speed", offsetof(DecisionRow, claimsSpeed), T::U8},
       {"claims_feed", offsetof(DecisionRow, claimsFeed), T::U8},
       {"authority", offsetof(DecisionRow, authority), T::U8},
       {"in_charge", offsetof(DecisionRow, inCharge), T::I32},
       {"speed_rpm", offsetof(DecisionRow, speed), T::F64},
       {"feed_m_s", offsetof(DecisionRow, feed), T::F64},
       {"reason", offsetof(DecisionRow, reason) + kReasonCode, T::U16},
       {"reason_numbers", offsetof(DecisionRow, reason) + kReasonNumbers, T::F64, 4}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<InputRow>() {
  static constexpr std::array<RowField, 6> kColumns{{{"step", offsetof(InputRow, step), T::U64},
                                                     {"action", offsetof(InputRow, action), T::U8},
                                                     {"authority", offsetof(InputRow, authority), T::U8},
                                                     {"advice", offsetof(InputRow, advice), T::U32, 1, true},
                                                     {"parameter", offsetof(InputRow, parameter), T::U32, 1, true},
                                                     {"value", offsetof(InputRow, value), T::F64, 1, true}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<VerdictRow>() {
  static constexpr std::array<RowField, 18> kColumns{
      {{"step", offsetof(VerdictRow, step), T::U64},
       {"detector", offsetof(VerdictRow, detector), T::I32},
       {"time_ns", offsetof(VerdictRow, time), T::I64},
       {"block_sequence", offsetof(VerdictRow, blockSequence), T::U64},
       {"state", offsetof(VerdictRow, state), T::U8},
       {"phase", offsetof(VerdictRow, phase), T::U8},
       {"kind", offsetof(VerdictRow, kind), T::U8},
       {"valid", offsetof(VerdictRow, valid), T::U8},
       {"early_warning", offsetof(VerdictRow, earlyWarning), T::U8},
       {"reason", offsetof(VerdictRow, reason) + kReasonCode, T::U16},
       {"reason_numbers", offsetof(VerdictRow, reason) + kReasonNumbers, T::F64, 4},
       {"frequency_hz", offsetof(VerdictRow, frequency), T::F64},
       {"frequency_sd_hz", offsetof(VerdictRow, frequencySd), T::F64},
       {"severity", offsetof(VerdictRow, severity), T::F64},
       {"spindle_hz", offsetof(VerdictRow, spindle), T::F64},
       {"since_onset_s", offsetof(VerdictRow, sinceOnset), T::F64},
       {"feed_since_onset_m", offsetof(VerdictRow, feedSinceOnset), T::F64},
       {"indicators", offsetof(VerdictRow, indicators), T::F64, kMaxIndicators}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<CommandRow>() {
  static constexpr std::array<RowField, 10> kColumns{
      {{"step", offsetof(CommandRow, step), T::U64},
       {"time_ns", offsetof(CommandRow, time), T::I64},
       {"sequence", offsetof(CommandRow, sequence), T::U64},
       {"kind", offsetof(CommandRow, kind), T::U8},
       {"speed", offsetof(CommandRow, speed), T::F64},
       {"feed", offsetof(CommandRow, feed), T::F64},
       {"lease_ns", offsetof(CommandRow, lease), T::I64},
       {"engagement", offsetof(CommandRow, engagement), T::U64},
       {"reason", offsetof(CommandRow, reason) + kReasonCode, T::U16},
       {"reason_numbers", offsetof(CommandRow, reason) + kReasonNumbers, T::F64, 4}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<EventRow>() {
  static constexpr std::array<RowField, 6> kColumns{
      {{"step", offsetof(EventRow, step), T::U64},
       {"time_ns", offsetof(EventRow, time), T::I64},
       {"number", offsetof(EventRow, number), T::U64},
       {"level", offsetof(EventRow, level), T::U8},
       {"reason", offsetof(EventRow, reason) + kReasonCode, T::U16},
       {"reason_numbers", offsetof(EventRow, reason) + kReasonNumbers, T::F64, 4}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<SegmentRow>() {
  static constexpr std::array<RowField, 4> kColumns{{{"step", offsetof(SegmentRow, step), T::U64},
                                                     {"offset", offsetof(SegmentRow, offset), T::U64},
                                                     {"first_sample_ns", offsetof(SegmentRow, firstSample), T::I64},
                                                     {"rate_hz", offsetof(SegmentRow, rate), T::F64}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<MarkerRow>() {
  static constexpr std::array<RowField, 8> kColumns{
      {{"number", offsetof(MarkerRow, number), T::U64},
       {"begin_ns", offsetof(MarkerRow, begin), T::I64},
       {"end_ns", offsetof(MarkerRow, end), T::I64},
       {"made_utc_ns", offsetof(MarkerRow, made), T::I64},
       {"removed", offsetof(MarkerRow, removed), T::U8},
       {"label", offsetof(MarkerRow, label), T::Text, kMarkerLabelSize},
       {"author", offsetof(MarkerRow, author), T::Text, kMarkerAuthorSize},
       {"note", offsetof(MarkerRow, note), T::Text, kMarkerNoteSize}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<TruthRow>() {
  static constexpr std::array<RowField, 2> kColumns{
      {{"name", offsetof(TruthRow, name), T::Text, kTruthNameSize}, {"value", offsetof(TruthRow, value), T::F64}}};
  return kColumns;
}

template <>
std::span<const RowField> columnsOf<TruthSampleRow>() {
  static constexpr std::array<RowField, 3> kColumns{{{"name", offsetof(TruthSampleRow, name), T::Text, kTruthNameSize},
                                                     {"time_ns", offsetof(TruthSampleRow, time), T::I64},
                                                     {"value", offsetof(TruthSampleRow, value), T::F64}}};
  return kColumns;
}

}  // namespace stillcut::record
