// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_report.h>

#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

namespace {

JointRows rowsOf(const IslandNumbers& numbers, std::size_t j, std::size_t lane, Vec3& impulses, Vec3& after,
                 Vec3& slopes) {
    const IslandLayout& layout = *numbers.layout;
    JointRows rows;
    const std::size_t first = layout.joints[j].firstRow,
                      links = layout.joints[j + 1].firstLink - layout.joints[j].firstLink;
    rows.body.fill(noBody);
    rows.ends = 2 * links;
    for (std::size_t k = 0; k < links; ++k) {
        const IslandLayout::Link& link = layout.links[layout.joints[j].firstLink + k];
        rows.body[2 * k] = numbers.bodyAt(link.a, lane);
        rows.body[2 * k + 1] = numbers.bodyAt(link.b, lane);
    }
    for (std::size_t i = first; i < layout.joints[j + 1].firstRow; ++i) {
        const auto at = [&](int field) { return numbers.row(i, field, lane); };
        JointRow& added = rows.add();
        const std::size_t r = i - first;
        for (std::size_t k = 0; k < links; ++k) {
            const int axis = k == 0 ? RowField::AxisX : RowField::SecondAxisX;
            const Vec3 a{-at(axis), -at(axis + 1), at(axis + 2)}, b{at(axis), at(axis + 1), at(axis + 3)};
            (k == 0 ? added.at : rows.far) = {a, b};
            const IslandLayout::Link& link = layout.links[layout.joints[j].firstLink + k];
            for (int c = 0; c < 3; ++c)
                after[r] += a[static_cast<std::size_t>(c)] * numbers.body(link.a, BodyField::Vx + c, lane) +
                            b[static_cast<std::size_t>(c)] * numbers.body(link.b, BodyField::Vx + c, lane);
        }
        impulses[r] = at(RowField::Impulse);
        added.holds = layout.rows[i].holds;
        added.bounded = layout.rows[i].bounded;
        if (added.holds) continue;
        added.push = at(RowField::Push) + at(RowField::TakenBack);
        added.dampPush = at(RowField::DampPush);
        added.low = at(RowField::Low);
        added.high = at(RowField::High);
        slopes[r] = at(RowField::Slope);
    }
    return rows;
}

}  // namespace

void reportRows(const IslandNumbers& numbers, StepObserver& observer) {
    for (std::size_t lane = 0; lane < numbers.width; ++lane) {
        if (numbers.active[lane] == 0) continue;
        for (std::size_t j = 0; j < numbers.layout->jointCount(); ++j) {
            Vec3 impulses{}, after{}, slopes{};
            const JointRows rows = rowsOf(numbers, j, lane, impulses, after, slopes);
            observer.noteRows(rows, impulses, after, slopes);
        }
    }
}

Vec2 givenMomentum(const IslandNumbers& numbers) {
    Vec2 sum(0, 0);
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        const auto at = [&](int field) { return numbers.body(n, field, lane); };
        if (numbers.active[lane] != 0)
            sum += at(BodyField::OwnMass) *
                   Vec2(at(BodyField::Vx) - at(BodyField::FreeX), at(BodyField::Vy) - at(BodyField::FreeY));
    });
    return sum;
}

}  // namespace plumb
