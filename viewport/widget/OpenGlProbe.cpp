#include "viewport/widget/OpenGlProbe.h"

#include "core/base/Parallel.h"
#include "core/base/limits/SoftwareRendererNeeds.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace rubble {
namespace {

struct Probe {
    Q_DECLARE_TR_FUNCTIONS(rubble::OpenGlProbe)
};

std::optional<QString> probed() {
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal") {
        return Probe::tr("The 3D view is unavailable: the platform \"%1\" does not support OpenGL.").arg(platform);
    }
    if (!areRendererThreadsLeft(availableProcessors()))
        return Probe::tr("The 3D view is unavailable: the system allows no more threads.");
    if (!isRendererMemoryLeft()) {
        return Probe::tr(
            "The 3D view is unavailable: too little memory is left. Close other programs, then start Rubble again.");
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create() || !context.makeCurrent(&surface)) {
        return Probe::tr("The 3D view is unavailable: this display does not support OpenGL.");
    }
    const QSurfaceFormat got = context.format();
    if (got.version() < format.version()) {
        return Probe::tr("The 3D view is unavailable: it needs OpenGL 3.3, but this display supports %1.%2.")
            .arg(got.majorVersion())
            .arg(got.minorVersion());
    }
    return std::nullopt;
}

}  // namespace

std::optional<QString> openGlError() {
    static const std::optional<QString> fault = probed();
    return fault;
}

}  // namespace rubble
