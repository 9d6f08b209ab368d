#pragma once

#include <QWidget>

namespace rubble {

/// The slider of the exploded view.
class ExplodeSlider : public QWidget {
    Q_OBJECT
public:
    explicit ExplodeSlider(QWidget* parent = nullptr);

signals:
    /// `factor`: see SceneOptions::explodeFactor.
    void factorChanged(double factor);
};

}  // namespace rubble
