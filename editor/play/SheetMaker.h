#pragma once

#include "viewport/film/SheetPicture.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

namespace rubble {

/// A variant with its picture, which is null where it has a fault.
struct SheetCell {
    SheetEntry entry;
    QImage picture;
};

/// Makes contact sheets in the background, one at a time: another one stops the one before.
class SheetMaker : public QObject {
    Q_OBJECT
public:
    explicit SheetMaker(QObject* parent = nullptr);
    ~SheetMaker() override;

    bool isBusy() const { return m_isBusy; }
    void make(SheetOrder order, const SheetLook& look);
    void cancel();

signals:
    void changed();
    void progressed(double fraction);
    /// A variant is there; in any order.
    void made(const rubble::SheetCell& cell);
    void failed(const QString& sentence);

private:
    void end(const Status& status);

    QThreadPool m_thread;
    CancelToken m_cancel;
    int m_sheet = 0;  // what is of an earlier one comes too late
    bool m_isBusy = false;
};

}  // namespace rubble
