// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/scenes.h>

#include <span>

namespace plumb::compare {
namespace {

struct Titled {
    const char* name;
    const char* title;
};

constexpr Titled flightTitles[] = {
    {"free_fall", "Free fall"},
    {"projectile", "A shot at 45 degrees"},
    {"projectile_damped", "A shot with drag"},
    {"spin_free", "A thrown hammer"},
    {"projectile_fan", "Five shots, 15 degrees apart"},
    {"projectile_fan_drag", "Five shots against the wind"},
    {"moving_target", "A shot at a flying duck"},
    {"terminal_speed", "Terminal speed"},
    {"two_body_orbit", "Two stars in orbit"},
    {"buoyant_box", "A box that floats"},
    {"magnet", "A magnet and iron on ice"},
};

constexpr Titled bounceTitles[] = {
    {"bounce_08", "A bounce of e = 0.8"},
    {"bounce_1", "A bounce of e = 1"},
    {"wall_touch", "A light touch of a wall"},
    {"head_on_1", "Head-on, e = 1"},
    {"head_on_05", "Head-on, e = 0.5"},
    {"head_on_0", "Head-on, e = 0"},
    {"oblique_1", "An oblique hit, e = 1"},
    {"oblique_08", "An oblique hit, e = 0.8"},
    {"slip_landing_sticks", "A spinning disc lands and grips"},
    {"slip_landing_slips", "A spinning disc lands and slips"},
    {"bullet_wall", "Fast discs against a thin wall"},
    {"elastic_gas", "A gas of twenty discs"},
};

constexpr Titled slopesTitles[] = {
    {"block_slides", "A block slides down"},
    {"block_sticks", "A block stays on a slope"},
    {"disc_rolls", "A disc rolls down 30 degrees"},
    {"disc_rolls_down", "A disc rolls down 20 degrees"},
    {"ring_rolls_down", "A ring rolls down"},
    {"slide_to_roll", "From sliding to rolling"},
    {"tip_below", "Just below the tipping angle"},
    {"tip_above", "Just past the tipping angle"},
    {"conveyor", "A box on a conveyor belt"},
    {"terrain_box", "A box over 1,000 pieces of hill"},
    {"terrain_disc", "A disc over 1,000 pieces of hill"},
    {"terrain_capsule", "A capsule over 1,000 pieces of hill"},
};

constexpr Titled pendulumsTitles[] = {
    {"pendulum_45", "A swing of 45 degrees"},        {"pendulum_150", "A swing of 150 degrees"},
    {"pendulum_step", "A swing at half the step"},   {"rod_pendulum_90", "A swinging rod"},
    {"double_pendulum", "A double pendulum"},        {"double_pendulum_minute", "A double pendulum for a minute"},
    {"pendulum_horizontal", "A swing from level"},   {"hanging_chain", "Three weights in a row"},
    {"spring_undamped", "A spring without damping"}, {"springs_damped", "Three damped springs"},
    {"cradle_one", "Newton's cradle, one disc"},     {"cradle_two", "Newton's cradle, two discs"},
    {"cradle_gap", "Newton's cradle with gaps"},     {"ballistic_pendulum", "A ballistic pendulum"},
};

constexpr Titled jointsTitles[] = {
    {"double_four_bar", "A double four-bar linkage"},
    {"atwood_machine", "Atwood's machine"},
    {"catenary", "A hanging chain of 20 links"},
    {"loaded_chain", "A chain under a thousandfold load"},
    {"bridge_under_load", "A bridge under load"},
    {"breaking_bridge", "A bridge that breaks"},
    {"car_over_hills", "A car over hills"},
    {"cart_of_a_ton", "A cart of a ton"},
    {"nine_carts", "Nine carts of a ton"},
    {"ragdoll", "A doll down the stairs"},
    {"doll_on_boulders", "A doll on boulders"},
    {"rope_heaps_up", "A rope that heaps up"},
    {"scissor_lift", "A scissor lift"},
    {"gear_train", "A gear train"},
};

constexpr Titled stacksTitles[] = {
    {"box_at_rest", "A box at rest"},
    {"stack_of_ten", "A stack of ten"},
    {"small_pyramid", "A small pyramid"},
    {"tall_stack", "A stack of thirty"},
    {"stack_awake", "A stack that may not sleep"},
    {"heavy_on_light", "Heavy on light"},
    {"arch", "A stone arch"},
    {"dominoes", "Dominoes"},
    {"small_tumbler", "A turning drum"},
};

constexpr Titled moversTitles[] = {
    {"tile_floor", "Over a floor of tiles"},  {"tile_wall", "Down a wall of tiles"},
    {"mover_wall", "A mover against a wall"}, {"platform_ride", "A ride on a platform"},
    {"maze_lap", "Ten laps of a maze"},       {"jump_1985", "A jump of 1985"},
    {"jump_modern", "A modern jump"},         {"one_way_platform", "A one-way platform"},
    {"steering", "Agents that steer"},
};

constexpr Titled worldsTitles[] = {
    {"wrap_head_on", "Across the seam of a round world"},
    {"wrap_billiard", "Billiards without edges"},
    {"sensor_gate", "A gate that counts"},
};

struct TitledGroup {
    const char* name;
    std::span<const Titled> scenes;
};

const TitledGroup titledGroups[] = {
    {"Flight", flightTitles},
    {"Bounce", bounceTitles},
    {"Slopes and rolling", slopesTitles},
    {"Pendulums and springs", pendulumsTitles},
    {"Joints and machines", jointsTitles},
    {"Stacks and heaps", stacksTitles},
    {"Movers and tiles", moversTitles},
    {"Worlds and sensors", worldsTitles},
};

}  // namespace

void giveTitle(Scene& scene) {
    for (const TitledGroup& group : titledGroups) {
        for (const Titled& titled : group.scenes) {
            if (scene.name != titled.name) continue;
            scene.title = titled.title;
            scene.group = group.name;
        }
    }
}

}  // namespace plumb::compare
