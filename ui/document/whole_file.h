// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a file completely or not at all, with reasons for failure that the window can show.
#pragma once

#include <QByteArray>
#include <QString>

namespace drillwave {

/// Writes a file completely or not at all. Returns the reason on failure, else an empty text. The reason is
/// one line that begins with the path, or with `name` if the path means nothing to users.
QString writeWholeFile(const QString& path, const QByteArray& bytes, const QString& name = {});

/// Writes a file completely or not at all. Returns the reason on failure without the path, else an empty
/// text.
QString replaceFile(const QString& path, const QByteArray& bytes);

}  // namespace drillwave
