/* A hundred people in C: half of them are split off, both halves get orders, and the hash is printed. */
#include <muster/muster.h>
#include <stdio.h>

/* Prints the sentence of a call that failed. */
static int good(MusterStatus status, const char* what) {
    if (status == MUSTER_OK) return 1;
    fprintf(stderr, "%s: %s: %s\n", what, muster_status_name(status), muster_last_error());
    return 0;
}

/* One director, who numbers the commands. */
static int submit(MusterWorldId world, MusterCommand* command) {
    static uint32_t sequence = 0;
    if (!good(muster_world_step_count(world, &command->step), "step count")) return 0;
    command->client = 1;
    command->sequence = sequence++;
    return good(muster_world_submit(world, command), muster_command_name(command->kind));
}

static int split(MusterWorldId world, MusterGroupId group) {
    const double shares[] = {1.0, 1.0};
    MusterCommand command = muster_default_command(MUSTER_COMMAND_SPLIT_GROUP);
    command.body.splitGroup.group = group;
    command.body.splitGroup.by = MUSTER_SPLIT_BY_SHARES;
    command.body.splitGroup.shares = shares;
    command.body.splitGroup.shareCount = 2;
    command.body.splitGroup.abreast = true;
    return submit(world, &command);
}

static int move(MusterWorldId world, MusterGroupId group, double x, double y) {
    MusterCommand command = muster_default_command(MUSTER_COMMAND_GIVE_ORDER);
    command.body.giveOrder.group = group;
    command.body.giveOrder.order.target.x = x;
    command.body.giveOrder.order.target.y = y;
    return submit(world, &command);
}

/* Steps and counts the events Arrived. */
static int run(MusterWorldId world, int steps, int* arrived) {
    int step;
    int32_t i, count;
    const MusterEvent* events;
    for (step = 0; step < steps; ++step) {
        if (!good(muster_world_step(world), "step")) return 0;
        if (!good(muster_world_events(world, &events, &count), "events")) return 0;
        for (i = 0; i < count; ++i)
            if (events[i].kind == MUSTER_EVENT_ARRIVED) ++*arrived;
    }
    return 1;
}

static int direct(MusterWorldId world) {
    MusterGroup first = muster_default_group(), second = muster_default_group();
    MusterCharacters characters = muster_default_characters();
    int arrived = 0;
    int32_t groups = 0;
    uint64_t hash = 0;
    if (!good(muster_world_group(world, 0, &first), "group") || !split(world, first.id)) return 0;
    if (!run(world, 1, &arrived)) return 0;
    if (!good(muster_world_group_count(world, &groups), "groups") || groups != 2) return 0;
    if (!good(muster_world_group(world, 0, &first), "group")) return 0;
    if (!good(muster_world_group(world, 1, &second), "group")) return 0;
    if (!move(world, first.id, 12.0, 8.0) || !move(world, second.id, 12.0, -8.0)) return 0;
    arrived = 0;
    if (!run(world, 1800, &arrived)) return 0;
    if (!good(muster_world_characters(world, &characters), "characters")) return 0;
    if (!good(muster_world_hash(world, &hash), "hash")) return 0;
    printf(
        "Muster %s: %d people in %d groups, %d arrived; the first stands at (%.2f, %.2f); hash %08lx%08lx\n",
        muster_version(), (int)characters.count, (int)groups, arrived, characters.position[0].x,
        characters.position[0].y, (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    return characters.count == 100 && arrived == 2;
}

int main(void) {
    MusterWorldDef def = muster_default_world_def();
    MusterGroupDef group = muster_default_group_def();
    MusterWorldId world;
    int done;
    def.box.min.x = -24.0;
    def.box.max.x = 24.0;
    group.count = 100;
    group.position.x = -12.0;
    def.groups = &group;
    def.groupCount = 1;
    if (!good(muster_world_create(&def, 1, &world), "world")) return 1;
    done = direct(world);
    return good(muster_world_destroy(world), "destroy") && done ? 0 : 1;
}
