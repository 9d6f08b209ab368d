#pragma once

#include "core/asset/FragmentPath.h"

#include <QWidget>

class QHBoxLayout;

namespace rubble {

/// Where one is: the asset, and the fragments that one went into, one behind the other. A click on one of them goes out to it.
class PlaceTrail : public QWidget {
    Q_OBJECT
public:
    explicit PlaceTrail(QWidget* parent);

    /// Shown only inside a fragment.
    void setPlace(const QString& asset, const FragmentPath& inside);

signals:
    void chosen(const rubble::FragmentPath& place);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void add(const QString& text, const FragmentPath& place, bool isHere);

    QString m_asset;
    FragmentPath m_inside;
    QHBoxLayout* m_layout;
};

}  // namespace rubble
