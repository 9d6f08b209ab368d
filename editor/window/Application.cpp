#include "editor/window/Application.h"

#include "core/base/Parallel.h"
#include "core/base/limits/MemoryReserve.h"
#include "core/base/limits/Threads.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace rubble {
namespace {

/// After events that are waiting, so that one sentence reports all that fail.
constexpr int kNoticeMilliseconds = 100;
/// Of Qt and of the editor's background jobs; besides, Qt paints with one thread for each processor.
constexpr int kThreads = 6;
/// What the program takes until its first window is shown, and more: where Qt and GLib get no memory, they end it.
constexpr std::size_t kAddressSpaceToStart = std::size_t{400} << 20;

}  // namespace

Application::Application(int& argumentCount, char** arguments)
    : QApplication(argumentCount, arguments),
      m_memorySentence(
          tr("Out of memory: the last action was not completed. Save the project, then use fewer fragments "
             "or smaller textures, or close other programs.")),
      m_threadSentence(
          tr("The system allows no more threads: the last action was not completed. Save the project, then "
             "close other programs.")) {
    holdMemoryReserve();
    m_notice.setSingleShot(true);
    m_notice.setInterval(kNoticeMilliseconds);
    connect(&m_notice, &QTimer::timeout, this, &Application::report);
}

std::optional<std::string> Application::startFault() {
    if (!isAddressSpaceLeft(kAddressSpaceToStart))
        return "Out of memory: close other programs, then start Rubble again.";
    const int threads = kThreads + availableProcessors();
    if (canStartThreads(threads)) return std::nullopt;
    return "Rubble needs " + std::to_string(threads) +
           " threads, but the system allows fewer. Close other programs, then start it again.";
}

void Application::terminate() noexcept {
    releaseMemoryReserve();
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        constexpr std::string_view kSentence =
            "Out of memory. The last backup of changes that were not saved is offered at the next start.\n";
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kSentence.data(), kSentence.size());
        ::_exit(1);
    } catch (...) {  // a fault of the program
    }
    std::abort();
}

bool Application::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {  // a container larger than memory can be
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::resource_unavailable_try_again) throw;
        m_isOfThreads = true;
    }
    noteOutOfMemory();
    return true;  // the receiver may have handled a part of it
}

void Application::noteOutOfMemory() noexcept {
    releaseMemoryReserve();
    try {
        if (!m_notice.isActive()) m_notice.start();
    } catch (const std::bad_alloc&) {  // the next event that fails reports it
    }
}

void Application::report() {
    emit ranOut(m_isOfThreads ? m_threadSentence : m_memorySentence);
    m_isOfThreads = false;
    holdMemoryReserve();
}

}  // namespace rubble

#include "moc_Application.cpp"
