// A phone's file for tests: a tone as AAC (or plain samples) in a container of libavformat's, beside a track without
// sound if wanted. Only where the tests are built with libavformat.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <cmath>
#include <string>

namespace stillcut::test {

class MediaFile {
 public:
  // `seconds` of a sine of `tone_Hz` at half of full scale, one channel. False: this build of the libraries cannot.
  static bool write(const std::string& path, const char* container, AVCodecID kind, int rate, double seconds,
                    double tone_Hz) {
    MediaFile file;
    const bool opened = file.open(path, container, kind, rate);
    return opened && file.encode(static_cast<int>(seconds * rate), tone_Hz);
  }

 private:
  MediaFile() = default;
  ~MediaFile() {
    if (file_ != nullptr && file_->pb != nullptr) avio_closep(&file_->pb);
    avformat_free_context(file_);
    avcodec_free_context(&encoder_);
    av_frame_free(&frame_);
    av_packet_free(&packet_);
  }

  bool open(const std::string& path, const char* container, AVCodecID kind, int rate) {
    av_log_set_level(AV_LOG_QUIET);
    const AVCodec* codec = avcodec_find_encoder(kind);
    if (codec == nullptr || avformat_alloc_output_context2(&file_, nullptr, container, path.c_str()) < 0) return false;
    encoder_ = avcodec_alloc_context3(codec);
    encoder_->sample_rate = rate;
    encoder_->sample_fmt = codec->sample_fmts[0];
    encoder_->bit_rate = 128'000;
    encoder_->time_base = {1, rate};
    av_channel_layout_default(&encoder_->ch_layout, 1);
    if ((file_->oformat->flags & AVFMT_GLOBALHEADER) != 0) encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (avcodec_open2(encoder_, codec, nullptr) < 0) return false;
    stream_ = avformat_new_stream(file_, nullptr);
    avcodec_parameters_from_context(stream_->codecpar, encoder_);
    stream_->time_base = encoder_->time_base;
    frame_ = av_frame_alloc();
    packet_ = av_packet_alloc();
    return avio_open(&file_->pb, path.c_str(), AVIO_FLAG_WRITE) >= 0 && avformat_write_header(file_, nullptr) >= 0;
  }

  bool encode(int frames, double tone_Hz) {
    const int piece = encoder_->frame_size > 0 ? encoder_->frame_size : 1024;
    for (int at = 0; at < frames; at += piece) {
      av_frame_unref(frame_);
      frame_->nb_samples = std::min(piece, frames - at);
      frame_->format = encoder_->sample_fmt;
      frame_->sample_rate = encoder_->sample_rate;
      frame_->pts = at;
      av_channel_layout_copy(&frame_->ch_layout, &encoder_->ch_layout);
      if (av_frame_get_buffer(frame_, 0) < 0) return false;
      for (int i = 0; i < frame_->nb_samples; ++i) {
        const double value = 0.5 * std::sin(2.0 * M_PI * tone_Hz * (at + i) / encoder_->sample_rate);
        if (encoder_->sample_fmt == AV_SAMPLE_FMT_FLTP) {
          reinterpret_cast<float*>(frame_->data[0])[i] = static_cast<float>(value);
        } else {
          reinterpret_cast<std::int16_t*>(frame_->data[0])[i] = static_cast<std::int16_t>(32767.0 * value);
        }
      }
      if (!send(frame_)) return false;
    }
    return send(nullptr) && av_write_trailer(file_) >= 0;
  }

  bool send(AVFrame* frame) {
    if (avcodec_send_frame(encoder_, frame) < 0) return false;
    while (avcodec_receive_packet(encoder_, packet_) >= 0) {
      av_packet_rescale_ts(packet_, encoder_->time_base, stream_->time_base);
      packet_->stream_index = stream_->index;
      if (av_interleaved_write_frame(file_, packet_) < 0) return false;
    }
    return true;
  }

  AVFormatContext* file_ = nullptr;
  AVCodecContext* encoder_ = nullptr;
  AVStream* stream_ = nullptr;
  AVFrame* frame_ = nullptr;
  AVPacket* packet_ = nullptr;
};

}  // namespace stillcut::test
