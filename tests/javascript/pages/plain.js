// What the plain page and its worker do with a library: scenarios to their last step, and a take.

/** A world of a scenario, by the fast plan, with its commands. */
function begin(muster, files, name) {
  for (const [path, text] of Object.entries(files)) muster.files.write(`/scenarios/${path}`, text);
  const path = `/scenarios/${name}.json`;
  const def = muster.Scenario.load(path).def();
  def.parameters.push({ name: 'plan.solver', value: 1 });
  const scenario = muster.Scenario.fromDef(def);
  const commands = muster.gesturesOfScenario(path, scenario);
  const world = scenario.createWorld();
  for (const command of commands) world.submit(command);
  return { world, def, commands };
}

/** The hashes after the last steps. */
export function play(muster, files, runs) {
  return runs.map(({ name, steps }) => {
    const { world } = begin(muster, files, name);
    world.step(steps);
    return world.hash().toString(16).padStart(16, '0');
  });
}

/** The bytes of a take, and the last hash. */
export function record(muster, files, name, steps) {
  const { world, def, commands } = begin(muster, files, name);
  const writer = muster.TakeWriter.create('/recorded.take', def, true);
  for (const command of commands) writer.command(command);
  for (let k = 0; k < steps; k += 1) {
    world.step();
    writer.observe(world);
  }
  writer.finish(world);
  return {
    bytes: [...muster.files.read('/recorded.take')],
    hash: world.hash().toString(16).padStart(16, '0'),
  };
}
