#pragma once

#include <QPointF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

namespace rubble {

/// What is written over the 3D view while a project is played: a coloured frame, figures, the charge of a throw and where it will
/// fly. It lets all events through.
class PlayHud : public QWidget {
    Q_OBJECT
public:
    explicit PlayHud(QWidget* parent);

    struct Content {
        bool isRunning = false;  // colours the frame
        QString title;           // "Playing"
        QStringList figures;
        QString hint;
        std::optional<double> charge;  // in (0, 1]: of a throw about to be let go
        QString chargeText;
        bool hasHeat = false;     // a legend of its colours
        bool isForecast = false;  // heat is what the throw that is aimed would do
        std::vector<QPointF> flight;
        bool isMet = false;  // the flight ends where it meets something
        bool operator==(const Content&) const = default;
    };
    void setContent(const Content& content);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void paintFrame(class QPainter& painter) const;
    void paintFlight(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;
    void paintCharge(QPainter& painter) const;
    void paintHeat(QPainter& painter) const;

    Content m_content;
};

}  // namespace rubble
