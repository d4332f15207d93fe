// What nearly every source of the screens includes: the standard library and Qt's widgets.
#pragma once

#include <QtCore/QtCore>
#include <QtGui/QtGui>
#include <QtWidgets/QtWidgets>

#include "packaging/cmake/precompiled/standard.h"
