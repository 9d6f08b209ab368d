#include "editor/background/ContactSheetGenerator.h"

#include <utility>

namespace rubble {

namespace {

QImage toQImage(const Image& image) {
    const QImage borrowed(image.pixels.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888);
    return borrowed.copy();
}

}  // namespace

ContactSheetGenerator::ContactSheetGenerator(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::progressed, this, &ContactSheetGenerator::progressed);
}

void ContactSheetGenerator::cancel() {
    if (!isBusy()) return;
    m_job.cancel();
    emit changed();
}

void ContactSheetGenerator::start(SheetRequest request, const SheetStyle& style) {
    cancel();
    m_job.start(
        [this, request = std::move(request), style](const TaskContext& task, const BackgroundJob::Post& post) {
            const auto add = [this, &post](SheetEntry entry, std::optional<Image> image) {
                const SheetCell cell{std::move(entry), image ? toQImage(*image) : QImage()};
                post([this, cell] { emit cellReady(cell); });
            };
            return drawContactSheet(request, style, add, task);
        },
        [this](const Status& status) {
            emit changed();
            if (!status && status.error().code != ErrorCode::Cancelled) {
                emit failed(QString::fromStdString(status.error().message));
            }
        });
    emit changed();
    emit progressed(0.0);
}

}  // namespace rubble

#include "moc_ContactSheetGenerator.cpp"
