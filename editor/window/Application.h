#pragma once

#include <QApplication>
#include <QTimer>

#include <optional>
#include <string>

namespace rubble {

/// The application object of the editor. Where memory or threads run out in an event, the rest of that event is left
/// out, and the editor goes on with the next one.
class Application : public QApplication {
    Q_OBJECT
public:
    Application(int& argumentCount, char** arguments);

    /// Why the editor cannot be started, as a sentence; nothing if it can. To be called before the constructor: Qt's
    /// painting waits forever for threads that the system does not allow.
    static std::optional<std::string> startFault();

    /// The program's terminate handler: where memory runs out in functions that may not throw, as many of Qt, it ends
    /// the process with a sentence instead of a signal. The last backup is offered at the next start.
    [[noreturn]] static void terminate() noexcept;

    bool notify(QObject* receiver, QEvent* event) override;
    /// Emits `ranOut` soon, once for all calls until then.
    void noteOutOfMemory() noexcept;

signals:
    /// Memory or threads have run out; the sentence says what to do. Emitted from the event loop.
    void ranOut(const QString& sentence);

private:
    void report();

    QTimer m_notice;
    QString m_memorySentence;  // made while there is memory
    QString m_threadSentence;
    bool m_isOfThreads = false;
};

}  // namespace rubble
