#pragma once

#include "core/base/Result.h"
#include "core/io/media/PictureSequence.h"
#include "viewport/render/Image.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rubble {

/// Encodes images and adds them to a sequence on a thread of its own, while the next ones are rendered; on the caller's
/// where the system allows no more threads.
class FrameWriter {
public:
    explicit FrameWriter(PictureSequence& sequence);
    /// Waits for the image that is being written; those behind it are dropped.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// Queues an image; waits while several are queued. Returns the first error of those before it.
    Status add(Image image);
    /// Waits for all images. Returns the first error.
    Status finish();

private:
    void run();

    PictureSequence& m_sequence;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Image> m_images;   // the first one is being written
    Status m_status = success();  // nothing is written after an error
    bool m_isStopping = false;
    std::jthread m_thread;  // last: it uses the others
};

}  // namespace rubble
