#pragma once
// What nearly every source without windows includes.

#include "Geometry.h"

#include <QColor>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QVariant>
