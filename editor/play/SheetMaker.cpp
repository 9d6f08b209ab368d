#include "editor/play/SheetMaker.h"

#include <QMetaObject>
#include <QThread>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

QImage imageOf(const Image& image) {
    const QImage borrowed(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888);
    return borrowed.copy();
}

}  // namespace

SheetMaker::SheetMaker(QObject* parent) : QObject(parent) { m_thread.setMaxThreadCount(1); }

SheetMaker::~SheetMaker() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void SheetMaker::cancel() {
    m_cancel.cancel();
    ++m_sheet;
    if (std::exchange(m_isBusy, false)) emit changed();
}

void SheetMaker::make(SheetOrder order, const SheetLook& look) {
    cancel();
    m_cancel = CancelToken();
    m_isBusy = true;
    emit changed();
    emit progressed(0.0);
    m_thread.start([this, sheet = m_sheet, order = std::move(order), look, cancel = m_cancel] {
        const auto inWindow = [this, sheet](auto work) {
            QMetaObject::invokeMethod(this, [this, sheet, work] {
                if (sheet == m_sheet) work();
            });
        };
        TaskContext task{.cancel = cancel, .progress = {}, .threads = std::max(1, QThread::idealThreadCount())};
        task.progress = [this, inWindow](double fraction) {
            inWindow([this, fraction] { emit progressed(fraction); });
        };
        const auto take = [this, inWindow](SheetEntry entry, std::optional<Image> picture) {
            const SheetCell cell{std::move(entry), picture ? imageOf(*picture) : QImage()};
            inWindow([this, cell] { emit made(cell); });
        };
        const Status status = drawContactSheet(order, look, take, task);
        inWindow([this, status] { end(status); });
    });
}

void SheetMaker::end(const Status& status) {
    m_isBusy = false;
    emit changed();
    if (!status && status.error().code != ErrorCode::Cancelled) {
        emit failed(QString::fromStdString(status.error().message));
    }
}

}  // namespace rubble
