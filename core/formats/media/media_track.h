// The sound track of one media file, decoded front to back. Thread: its owner's; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"

struct AVFormatContext;
struct AVCodecContext;
struct AVPacket;
struct AVFrame;

namespace stillcut::record {

class MediaTrack {
 public:
  static Result<std::unique_ptr<MediaTrack>> open(const std::string& path);
  ~MediaTrack();
  MediaTrack(const MediaTrack&) = delete;
  MediaTrack& operator=(const MediaTrack&) = delete;

  // The next decoded piece. False: the end, or damage: see damaged().
  Result<bool> next();
  // Of the piece at hand: frames, and one sample as a fraction of full scale.
  int frames() const;
  float sample(int channel, int frame) const;

  std::string kind() const;  // "QuickTime / MOV, aac"
  int channels() const { return channels_; }
  int rate() const { return rate_; }         // [Hz]; known after the first piece
  int tracks() const { return tracks_; }     // of sound
  double promised() const;                   // [s] that the container says it lasts; 0: it does not
  bool damaged() const { return damaged_; }  // it ended before its end

 private:
  explicit MediaTrack(std::string path);
  Status openDecoder();
  Result<bool> takeFrame();

  std::string path_;
  AVFormatContext* file_ = nullptr;
  AVCodecContext* decoder_ = nullptr;
  AVPacket* packet_ = nullptr;
  AVFrame* frame_ = nullptr;
  int track_ = -1;
  int tracks_ = 0;
  int channels_ = 0;
  int rate_ = 0;
  bool drained_ = false;
  bool damaged_ = false;
};

}  // namespace stillcut::record
