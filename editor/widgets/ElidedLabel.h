#pragma once

#include <QLabel>

namespace rubble {

/// A label with one line of plain text, which is elided where it has no room; then its tooltip is the whole text, above
/// toolTip().
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;

    bool isElided() const;
    /// As narrow as an ellipsis.
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;
};

}  // namespace rubble
