#include "core/formats/media/media_track.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <array>
#include <utility>

namespace stillcut::record {
namespace {

Message whyNot(int code) {
  if (code == AVERROR_INVALIDDATA || code == AVERROR_EOF)
    return message("damaged, or cut off: what records into it writes its index when it ends");
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return foreign(text.data());
}

template <class T>
float scaled(const std::uint8_t* data, int at, double zero, double full) {
  return static_cast<float>((static_cast<double>(reinterpret_cast<const T*>(data)[at]) - zero) / full);
}

}  // namespace

MediaTrack::MediaTrack(std::string path) : path_(std::move(path)) {}

MediaTrack::~MediaTrack() {
  av_frame_free(&frame_);
  av_packet_free(&packet_);
  avcodec_free_context(&decoder_);
  avformat_close_input(&file_);
}

Result<std::unique_ptr<MediaTrack>> MediaTrack::open(const std::string& path) {
  av_log_set_level(AV_LOG_QUIET);
  std::unique_ptr<MediaTrack> track(new MediaTrack(path));
  // No other file and no network, whatever the file names.
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  const int opened = avformat_open_input(&track->file_, ("file:" + path).c_str(), nullptr, &options);
  av_dict_free(&options);
  if (opened < 0) return Error{path, message("its container cannot be read"), whyNot(opened)};
  if (const int found = avformat_find_stream_info(track->file_, nullptr); found < 0)
    return Error{path, message("its container cannot be read"), whyNot(found)};
  if (const Status s = track->openDecoder(); !s) return s.error();
  return track;
}

Status MediaTrack::openDecoder() {
  const AVCodec* codec = nullptr;
  track_ = av_find_best_stream(file_, AVMEDIA_TYPE_AUDIO, -1, -1, &codec, 0);
  for (unsigned i = 0; i < file_->nb_streams; ++i) {
    AVStream* stream = file_->streams[i];
    if (stream->codecpar->codec_type == AVMEDIA_TYPE_AUDIO) ++tracks_;
    if (static_cast<int>(i) != track_) stream->discard = AVDISCARD_ALL;
  }
  if (tracks_ == 0) return Error{path_, message("holds no sound track")};
  if (track_ < 0 || codec == nullptr)
    return Error{path_, message("no decoder for its sound track"),
                 message("convert it to WAV: ffmpeg -i FILE cut.wav")};
  decoder_ = avcodec_alloc_context3(codec);
  packet_ = av_packet_alloc();
  frame_ = av_frame_alloc();
  if (decoder_ == nullptr || packet_ == nullptr || frame_ == nullptr)
    return Error{path_, message("cannot be read"), message("not enough memory")};
  avcodec_parameters_to_context(decoder_, file_->streams[track_]->codecpar);
  decoder_->pkt_timebase = file_->streams[track_]->time_base;
  if (const int opened = avcodec_open2(decoder_, codec, nullptr); opened < 0)
    return Error{path_, message("no decoder for its sound track"), whyNot(opened)};
  return Done{};
}

// A frame must be like those before it.
Result<bool> MediaTrack::takeFrame() {
  if (rate_ == 0) {
    rate_ = frame_->sample_rate;
    channels_ = frame_->ch_layout.nb_channels;
  }
  if (frame_->sample_rate != rate_ || frame_->ch_layout.nb_channels != channels_)
    return Error{path_, message("its sampling rate or number of channels changes within it")};
  return true;
}

Result<bool> MediaTrack::next() {
  while (!damaged_) {
    const int got = avcodec_receive_frame(decoder_, frame_);
    if (got >= 0) return takeFrame();
    if (got == AVERROR_EOF) return false;
    if (got != AVERROR(EAGAIN)) break;
    av_packet_unref(packet_);
    int read = drained_ ? AVERROR_EOF : av_read_frame(file_, packet_);
    if (read >= 0 && packet_->stream_index != track_) continue;
    if (read < 0 && read != AVERROR_EOF) damaged_ = true;
    drained_ = read < 0;
    const int sent = avcodec_send_packet(decoder_, drained_ ? nullptr : packet_);
    if (sent < 0 && sent != AVERROR_EOF) break;
    if (damaged_) return next();
  }
  damaged_ = true;
  return false;
}

int MediaTrack::frames() const {
  return frame_->nb_samples;
}

float MediaTrack::sample(int channel, int frame) const {
  const auto format = static_cast<AVSampleFormat>(frame_->format);
  const bool planar = av_sample_fmt_is_planar(format) != 0;
  const std::uint8_t* data = frame_->extended_data[planar ? channel : 0];
  const int at = planar ? frame : frame * channels_ + channel;
  constexpr double kFull8 = 128.0, kFull16 = 32768.0, kFull32 = 2147483648.0;
  switch (av_get_packed_sample_fmt(format)) {
    case AV_SAMPLE_FMT_U8:
      return scaled<std::uint8_t>(data, at, kFull8, kFull8);
    case AV_SAMPLE_FMT_S16:
      return scaled<std::int16_t>(data, at, 0.0, kFull16);
    case AV_SAMPLE_FMT_S32:
      return scaled<std::int32_t>(data, at, 0.0, kFull32);
    case AV_SAMPLE_FMT_DBL:
      return scaled<double>(data, at, 0.0, 1.0);
    case AV_SAMPLE_FMT_FLT:
      return scaled<float>(data, at, 0.0, 1.0);
    default:
      return 0.0F;
  }
}

double MediaTrack::promised() const {
  const AVStream* stream = file_->streams[track_];
  const bool guessed = file_->duration_estimation_method == AVFMT_DURATION_FROM_BITRATE;
  if (guessed || stream->duration == AV_NOPTS_VALUE || stream->duration <= 0) return 0.0;
  return static_cast<double>(stream->duration) * av_q2d(stream->time_base);
}

std::string MediaTrack::kind() const {
  return std::string(file_->iformat->long_name) + ", " + avcodec_get_name(decoder_->codec_id);
}

}  // namespace stillcut::record
