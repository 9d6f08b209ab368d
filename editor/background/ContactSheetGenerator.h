#pragma once

#include "editor/document/jobs/BackgroundJob.h"
#include "viewport/video/ContactSheetPainter.h"

#include <QImage>

namespace rubble {

/// A variant with its image, which is null if the variant has an error.
struct SheetCell {
    SheetEntry entry;
    QImage image;
};

/// Generates contact sheets in the background, one at a time: a new one replaces the running one.
class ContactSheetGenerator : public QObject {
    Q_OBJECT
public:
    explicit ContactSheetGenerator(QObject* parent = nullptr);

    bool isBusy() const { return m_job.isRunning(); }
    void start(SheetRequest request, const SheetStyle& style);
    void cancel();

signals:
    /// isBusy() changed.
    void changed();
    void progressed(double fraction);
    /// A variant is complete; variants complete in any order.
    void cellReady(const rubble::SheetCell& cell);
    void failed(const QString& sentence);

private:
    BackgroundJob m_job;
};

}  // namespace rubble
