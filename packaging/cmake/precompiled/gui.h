// What nearly every source of the models behind the screens includes: the standard library and Qt without widgets.
#pragma once

#include <QtCore/QtCore>
#include <QtGui/QtGui>

#include "packaging/cmake/precompiled/standard.h"
