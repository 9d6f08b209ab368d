#pragma once

#include <QApplication>
#include <QTimer>

namespace rubble {

/// The application object of the editor. Where memory or threads run out in an event, the rest of that event is left
/// out, and the editor goes on with the next one.
class Application : public QApplication {
    Q_OBJECT
public:
    Application(int& argumentCount, char** arguments);

    bool notify(QObject* receiver, QEvent* event) override;
    /// Emits `ranOut` soon, once for all calls until then.
    void noteOutOfMemory() noexcept;

signals:
    /// Memory or threads have run out; the sentence says what to do. Emitted from the event loop.
    void ranOut(const QString& sentence);

private:
    void tell();

    QTimer m_notice;
    QString m_memorySentence;  // made while there is memory
    QString m_threadSentence;
    bool m_isOfThreads = false;
};

}  // namespace rubble
