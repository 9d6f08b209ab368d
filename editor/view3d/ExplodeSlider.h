#pragma once

#include <QWidget>

namespace rubble {

/// The slider of the exploded view.
class ExplodeSlider : public QWidget {
    Q_OBJECT
public:
    explicit ExplodeSlider(QWidget* parent = nullptr);

    /// The least size: tool bars grow it.
    QSize sizeHint() const override;

signals:
    /// `factor`: see SceneOptions::explodeFactor.
    void factorChanged(double factor);
};

}  // namespace rubble
