// SPDX-License-Identifier: MIT
#include <map>

#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

using Answers = std::map<std::string, std::string>;

const Answers ofFlights{
    {"free_fall", "It falls by {drop of y of ball} in {duration}, to {speed of ball}."},
    {"projectile",
     "It rises to {first maximum of y of ball} at {time when first maximum of y of ball}, and comes "
     "{x of ball when y first returns to 0} far."},
    {"projectile_damped",
     "It rises to {first maximum of y of ball}, and lands {x of ball when y first returns to 0} far, at "
     "{time when y of ball first returns to 0}."},
    {"spin_free", "It turns by {change of angle of hammer}; its point of balance flies like a ball."},
    {"projectile_fan",
     "45 degrees comes {x of ball_45 when y first returns to 0} far, 30 and 60 degrees "
     "{x of ball_30 when y first returns to 0} and {x of ball_60 when y first returns to 0}, 15 and 75 degrees "
     "{x of ball_15 when y first returns to 0} and {x of ball_75 when y first returns to 0}."},
    {"projectile_fan_drag",
     "45 degrees comes {x of ball_45 when y first returns to 0} far, 30 and 60 degrees "
     "{x of ball_30 when y first returns to 0} and {x of ball_60 when y first returns to 0}, 15 and 75 degrees "
     "{x of ball_15 when y first returns to 0} and {x of ball_75 when y first returns to 0}."},
    {"moving_target", "{probe hits} of the shots hit."},
    {"terminal_speed", "It falls at {speed of ball} in the end, after {drop of y of ball}."},
    {"two_body_orbit", "In the end the star is {metric error_end} from where Kepler has it."},
    {"buoyant_box", "It bobs up to {largest y of box}, down to {smallest y of box}, once in {period of y of box}."},
    {"magnet", "They meet at x = {probe meets_at}; the iron comes to {largest speed of iron}."},
};

const Answers ofImpacts{
    {"bounce_08",
     "Let go at {y of ball at start}, it comes back to {first maximum of y of ball}, then to "
     "{second maximum of y of ball}; it lies still from {metric settle_time} on."},
    {"bounce_1", "Its last apex is {last maximum of y of ball} high; it was let go at {y of ball at start}."},
    {"wall_touch", "It leaves the wall at {speed of ball}."},
    {"head_on_1", "They part at {vx of disc_a} and {vx of disc_b}."},
    {"head_on_05", "They part at {vx of disc_a} and {vx of disc_b}."},
    {"head_on_0", "They go on at {vx of disc_a} and {vx of disc_b}."},
    {"oblique_1", "One goes on at {vx of disc_a} and {vy of disc_a}, the other at {vx of disc_b} and {vy of disc_b}."},
    {"oblique_08", "One goes on at {vx of disc_a} and {vy of disc_a}, the other at {vx of disc_b} and {vy of disc_b}."},
    {"slip_landing_sticks",
     "Its spin is {spin of disc at start} before, {spin of disc when first maximum of y} after, at "
     "{vx of disc when first maximum of y}."},
    {"slip_landing_slips",
     "Its spin is {spin of disc at start} before, {spin of disc when first maximum of y} after the first landing, and "
     "{spin of disc} in the end."},
    {"bullet_wall",
     "The disc at {speed of disc_1000 at start} ends at x = {x of disc_1000}, the one at {speed of disc_10 at start} "
     "at "
     "{x of disc_10}."},
};

const Answers ofSlopes{
    {"block_slides", "After {duration} it slides at {speed of block}."},
    {"block_sticks", "After {duration} it has moved by {change of x of block}."},
    {"disc_rolls", "After {duration} it rolls at {speed of disc}."},
    {"disc_rolls_down", "After {duration} it rolls at {speed of roller}."},
    {"ring_rolls_down", "After {duration} it rolls at {speed of roller}; the scene before has a disc."},
    {"slide_to_roll", "In the end it rolls at {speed of disc}, and spins at {spin of disc}."},
    {"tip_below", "It tilts by {change of angle of block}."},
    {"tip_above", "It has tilted by {change of angle of block} after {duration}."},
    {"conveyor", "It comes {change of x of box} far in {duration}, and rides at {vx of box} in the end."},
    {"terrain_box", "It is at {speed of body} in the end, {change of x of body} farther."},
    {"terrain_disc", "Its energy changes by {metric energy_drift}."},
    {"terrain_capsule", "It is at {speed of body} in the end, {change of x of body} farther."},
    {"tile_floor",
     "The box catches {probe snags_box} times, the disc {probe snags_disc}, the capsule "
     "{probe snags_capsule}, the mover {probe snags_mover}."},
    {"tile_wall",
     "The box catches {probe snags_box} times, the disc {probe snags_disc}, the capsule "
     "{probe snags_capsule}, the mover {probe snags_mover}."},
};

const Answers ofMovers{
    {"mover_wall", "It stops at x = {x of hero}."},
    {"platform_ride", "It slips by {metric probe.slip} at most."},
    {"maze_lap", "It is {metric error_end} off its lane in the end."},
    {"jump_1985",
     "It rises by {change of y of hero when first maximum of y} until {time when first maximum of y of hero}, and is "
     "at "
     "most {metric error_max} off its tables. 16 pixels are a metre."},
    {"jump_modern",
     "It rises by {change of y of hero when first maximum of y}, is back after {time when y of hero last returns to "
     "start}, and is at most {metric error_max} off its formula."},
    {"steering",
     "One comes {change of x of seeker} nearer, one flees {change of x of fleer} farther, one is {y of arriver} from "
     "where it arrives; the one that pursues is {probe gap} from its quarry after {duration}."},
    {"wrap_head_on", "After {duration} they are {metric error_end} from where the formula has them."},
    {"wrap_billiard", "Energy changes by {metric energy_drift}, momentum by {metric momentum_drift}."},
};

const Answers ofPendulums{
    {"pendulum_45", "A swing from end to end and back takes {period of x of bob}."},
    {"pendulum_150", "A swing from end to end and back takes {period of x of bob}."},
    {"pendulum_step", "At this step it is {metric error_max} off."},
    {"rod_pendulum_90", "A swing from end to end and back takes {period of x of rod}."},
    {"double_pendulum", "Energy changes by {metric energy_drift} in {duration}. Where the engines part is told below."},
    {"double_pendulum_minute", "Energy changes by {metric energy_drift} in {duration}."},
    {"pendulum_horizontal",
     "It is across at {time when first maximum of x of bob}, at x = {first maximum of x of bob}."},
    {"double_four_bar", "Energy changes by {metric energy_drift}; hinges open by up to {metric joint_error_max}."},
    {"hanging_chain", "From the top the rods pull with {probe pull_1}, {probe pull_2} and {probe pull_3}."},
    {"spring_undamped", "Energy changes by {metric energy_drift} in {duration}."},
    {"springs_damped",
     "They come up to {largest y of swings}, {largest y of critical} and {largest y of creeps}; the first is there "
     "after {time when first maximum of y of swings}, and swings back."},
    {"atwood_machine", "They move at {speed of heavy} after {duration}; the rope pulls with {probe pull}."},
    {"cradle_one",
     "The last disc comes out by {change of x of disc_5 when first maximum of x} at {time when first maximum of x of "
     "disc_5}."},
    {"cradle_two",
     "The last disc comes out by {change of x of disc_5 when first maximum of x}, the one before it by "
     "{change of x of disc_4 when first maximum of x}."},
    {"cradle_gap", "The last disc comes out by {change of x of disc_5 when first maximum of x}."},
    {"ballistic_pendulum", "The block rises by {largest probe rise}."},
};

const Answers ofJoints{
    {"catenary", "It moves by {metric error_max} at most, and pulls with {probe pull}."},
    {"loaded_chain", "A hinge opens by {metric joint_error_max} at most; the top one pulls with {probe pull}."},
    {"bridge_under_load",
     "A hinge opens by {metric joint_error_max} at most; it is at rest from {metric settle_time} on."},
    {"breaking_bridge",
     "The weak joint has broken {probe broken} times; a hinge opens by {metric joint_error_max} at most."},
    {"car_over_hills", "It drives {change of x of body}, at {probe pace_after} in the end."},
    {"cart_of_a_ton", "It rests {probe height} high; an axle opens by {metric joint_error_max} at most."},
    {"nine_carts", "The first rests {probe cart_1_height} high; an axle opens by {metric joint_error_max} at most."},
    {"ragdoll", "A joint opens by {metric joint_error_max} at most; it lies still from {metric settle_time} on."},
    {"doll_on_boulders",
     "A joint opens by {metric joint_error_max} at most; all lies still from {metric settle_time} on."},
    {"rope_heaps_up", "A hinge opens by {metric joint_error_max} at most; it lies still from {metric settle_time} on."},
    {"scissor_lift", "It lifts to {probe height}, and is tilted by {probe tilt}."},
    {"gear_train",
     "After {duration} the wheels turn at {spin of wheel_1}, {spin of wheel_2} and {spin of wheel_3}; the rack "
     "moves at {speed of rack}."},
    {"sensor_gate",
     "The gates count {probe count_0}, {probe count_1}, {probe count_2}, {probe count_3} and "
     "{probe count_4} discs."},
    {"one_way_platform", "The ball rises to {largest y of thrown}, and lies at {y of thrown}."},
};

const Answers ofHeaps{
    {"box_at_rest", "It moves by {metric error_max} at most, and presses with {probe normal}."},
    {"stack_of_ten", "The lowest contact carries {probe normal_10}, the highest {probe normal_1}."},
    {"small_pyramid", "Boxes overlap by {metric penetration_max} at most; at rest from {metric settle_time} on."},
    {"tall_stack", "The top sinks by {drop of y of box_30} in {duration}, and moves {change of x of box_30} aside."},
    {"stack_awake", "The top sinks by {drop of y of box_15} in {duration}, and moves {change of x of box_15} aside."},
    {"heavy_on_light", "The heavy box sinks by {drop of y of box_3}."},
    {"arch", "The keystone sinks by {drop of y of stone_8}."},
    {"dominoes", "The last one has turned by {change of angle of domino_15}."},
    {"elastic_gas", "Energy changes by {metric energy_drift} in {duration}."},
    {"small_tumbler", "They overlap by {metric penetration_max} at most."},
};

}  // namespace

std::string answerTo(const std::string& scene) {
    for (const Answers* answers : {&ofFlights, &ofImpacts, &ofSlopes, &ofMovers, &ofPendulums, &ofJoints, &ofHeaps})
        if (const auto found = answers->find(scene); found != answers->end()) return found->second;
    return "";
}

}  // namespace plumb::compare
