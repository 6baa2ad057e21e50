// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "link/files/backgroundjob.h"
#include "model/path/pathfile.h"

namespace nmc {

class PathsPage;

/// Reads path files in a background thread, one at a time, for the page of paths. GUI thread.
class PathController : public QObject {
    Q_OBJECT

public:
    PathController();

    /// The page receives the content, or the reason why the file cannot be read.
    void open(const QString& file, const std::vector<PathColumn>& axes, PathsPage& page);

private:
    struct Reading;

    void end();

    BackgroundJob m_job;
    std::shared_ptr<Reading> m_reading;
    PathsPage* m_page = nullptr;
};

}  // namespace nmc
