#include "editor/window/Application.h"

#include "core/base/limits/MemoryReserve.h"

#include <new>
#include <stdexcept>
#include <system_error>

namespace rubble {
namespace {

/// After events that are waiting, so that one sentence tells of all that fail.
constexpr int kNoticeMilliseconds = 100;

}  // namespace

Application::Application(int& argumentCount, char** arguments)
    : QApplication(argumentCount, arguments),
      m_memorySentence(
          tr("Out of memory: the last action was not completed. Save the project, then use fewer fragments "
             "or close other programs.")),
      m_threadSentence(
          tr("The system allows no more threads: the last action was not completed. Save the project, then "
             "close other programs.")) {
    holdMemoryReserve();
    m_notice.setSingleShot(true);
    m_notice.setInterval(kNoticeMilliseconds);
    connect(&m_notice, &QTimer::timeout, this, &Application::tell);
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
    } catch (const std::bad_alloc&) {  // the next event that fails tells
    }
}

void Application::tell() {
    emit ranOut(m_isOfThreads ? m_threadSentence : m_memorySentence);
    m_isOfThreads = false;
    holdMemoryReserve();
}

}  // namespace rubble

#include "moc_Application.cpp"
