#pragma once

#include "viewport/scene/SceneBuilder.h"

#include <QWidget>

namespace rubble {

/// What the colours of pieces and the lines between them stand for, in a corner of the 3D view. It lets all events through.
class SceneLegend : public QWidget {
    Q_OBJECT
public:
    explicit SceneLegend(QWidget* parent);

    struct Content {
        SceneColouring colouring = SceneColouring::Material;
        std::optional<ValueRange> range;  // none: colours show no figure
        double largestBond = 0.0;         // m^2; 0: there are no lines
        bool operator==(const Content&) const = default;
    };
    void setContent(const Content& content);
    /// As it can be read: the title, both ends and what the widest line stands for.
    QStringList texts() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    Content m_content;
};

}  // namespace rubble
