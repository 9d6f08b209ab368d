#include "viewport/video/FrameWriter.h"

#include "core/base/OutOfMemory.h"
#include "core/base/limits/Threads.h"

#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kMaxQueued = 3;  // images: enough to even out, at 100 MB each

Status write(PictureSequence& sequence, const Image& image) {
    return orOutOfMemory("writing images", [&]() -> Status {
        const Result<std::string> png = pngOf(image, PngEffort::Quick);
        return png ? sequence.add(*png) : Status(png.error());
    });
}

}  // namespace

FrameWriter::FrameWriter(PictureSequence& sequence)
    : m_sequence(sequence), m_thread(startedThread([this] { run(); })) {}

FrameWriter::~FrameWriter() {
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping = true;
    }
    m_changed.notify_all();
}

Status FrameWriter::add(Image image) {
    if (!m_thread.joinable()) {
        if (m_status) m_status = write(m_sequence, image);
        return m_status;
    }
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_images.size() < kMaxQueued || !m_status; });
    if (m_status) m_images.push_back(std::move(image));
    m_changed.notify_all();
    return m_status;
}

Status FrameWriter::finish() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_images.empty() || !m_status; });
    return m_status;
}

void FrameWriter::run() {
    std::unique_lock lock(m_mutex);
    while (true) {
        m_changed.wait(lock, [this] { return !m_images.empty() || m_isStopping; });
        if (m_isStopping || !m_status) return;
        const Image& image = m_images.front();  // stays in place while others are added
        lock.unlock();
        Status written = write(m_sequence, image);
        lock.lock();
        m_status = std::move(written);
        m_images.pop_front();
        m_changed.notify_all();
    }
}

}  // namespace rubble
