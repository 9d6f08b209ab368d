#pragma once

#include "core/asset/project/FragmentPath.h"

#include <QWidget>

class QHBoxLayout;

namespace rubble {

/// Shows the path to the entered fragment: the asset and the fragments on the way. A click on one of them exits to it.
class Breadcrumb : public QWidget {
    Q_OBJECT
public:
    explicit Breadcrumb(QWidget* parent);

    /// Hidden if `fragment` is empty.
    void setPath(const QString& asset, const FragmentPath& fragment);

signals:
    void clicked(const rubble::FragmentPath& fragment);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void add(const QString& text, const FragmentPath& fragment, bool isCurrent);

    QString m_asset;
    FragmentPath m_fragment;
    QHBoxLayout* m_layout;
};

}  // namespace rubble
