#pragma once

#include "viewport/widget/ViewportOverlay.h"

#include <QLineF>
#include <QPointF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace rubble {

/// The head-up display of play over the 3D view: a coloured frame, statistics, the charge and trajectory of a throw,
/// and the spring of a grab.
class PlayHud : public OverlayItem {
    Q_OBJECT
public:
    using OverlayItem::OverlayItem;

    struct Content {
        bool isRunning = false;  // colours the frame
        QString title;           // "Playing"
        QStringList statistics;
        QString collapse;  // what would fall without the body at the pointer
        QString hint;
        std::optional<double> charge;  // in [0, 1], of a throw being charged
        QString chargeText;
        bool hasHeat = false;     // shows the legend of the heat colours
        bool hasBonds = false;    // shows that of the damage of bonds
        bool isForecast = false;  // heat is the forecast of the aimed throw
        std::vector<QLineF> trajectory;
        std::optional<QPointF> hit;    // at which the trajectory ends
        std::optional<QLineF> spring;  // from a grabbed body to the pointer
        QString grabText;              // "120 kg", why it cannot be lifted
        bool isTooHeavy = false;
        bool operator==(const Content&) const = default;
    };
    void setContent(const Content& content);
    /// Shows or hides it; hidden initially.
    void setVisible(bool isVisible);

    void paint(QPainter& painter, QSize size) const override;
    std::vector<QRect> plates(QSize size, const QFont& font) const override;
    QString accessibleText() const override;

private:
    void paintFrame(QPainter& painter, QSize size) const;
    void paintTrajectory(QPainter& painter) const;
    void paintSpring(QPainter& painter, QSize size) const;
    void paintTexts(QPainter& painter, const QRect& plate) const;
    void paintHint(QPainter& painter, const QRect& plate) const;
    void paintCharge(QPainter& painter, QSize size) const;
    bool hasLegend() const { return m_content.hasHeat || m_content.hasBonds; }
    void paintLegend(QPainter& painter, const QRect& plate) const;
    QString legendTitle() const;
    QStringList lines() const;
    QRect textPlate(const QStringList& lines, const QFont& font) const;
    QRect legendPlate(QSize size, const QRect& texts, const QFont& font) const;
    QRect hintPlate(QSize size, const QFont& font) const;
    bool hasHint(QSize size, const QFont& font) const;

    Content m_content;
    bool m_isVisible = false;
};

}  // namespace rubble
