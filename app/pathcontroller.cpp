// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pathcontroller.h"

#include <QFileInfo>
#include <optional>
#include <utility>

#include "link/files/machineio.h"
#include "widgets/paths/pathspage.h"

namespace nmc {

namespace {

/// More than the longest path of all axes needs.
constexpr std::size_t kLimit = 256U << 20U;  ///< bytes

}  // namespace

/// Filled by the background job.
struct PathController::Reading {
    QString file;
    std::vector<PathColumn> axes;
    std::optional<FileError> error{};
    tl::expected<PathTable, std::vector<PathProblem>> table{};

    void read() {
        const auto text = readFile(file, kLimit);
        if (text)
            table = readPath(*text, axes);
        else
            error = text.error();
    }
};

PathController::PathController() {
    connect(&m_job, &BackgroundJob::ended, this, &PathController::end);
}

void PathController::open(const QString& file, const std::vector<PathColumn>& axes, PathsPage& page) {
    m_job.cancel();
    m_page = &page;
    m_reading = std::make_shared<Reading>(Reading{file, axes});
    page.showReading();
    m_job.start([reading = m_reading](const BackgroundJob::Cancelled& /*cancelled*/) { reading->read(); });
}

void PathController::end() {
    const std::shared_ptr<Reading> reading = std::exchange(m_reading, nullptr);
    const QString name = QFileInfo(reading->file).fileName();
    if (reading->error)
        return m_page->showNotRead(*reading->error);
    if (!reading->table)
        return m_page->showProblems(name, reading->table.error(), reading->axes);
    std::vector<PathColumn> axes = columnsOf(*reading->table, reading->axes);
    m_page->showPath({name, std::move(*reading->table), std::move(axes), {}});
}

}  // namespace nmc
