// The companies as instanced capsules with three.js, without a bundler. Click on the ground to send the blue one.
import * as THREE from 'three';
import { Crowd, kHouses } from './crowd.js';

const kColours = [new THREE.Color(0x1e66c8), new THREE.Color(0xc62f2f)];
const line = document.querySelector('#line');
const crowd = await Crowd.make();

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.shadowMap.enabled = true;
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xcfd8dc);
const camera = new THREE.PerspectiveCamera(45, 1, 1, 200);
// As in the engine: x to the right, y forward, z up.
camera.up.set(0, 0, 1);
camera.position.set(0, -46, 34);
camera.lookAt(0, -2, 0);

const sun = new THREE.DirectionalLight(0xffffff, 2.2);
sun.position.set(-25, -20, 40);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
Object.assign(sun.shadow.camera, {
  left: -42,
  right: 42,
  top: 32,
  bottom: -32,
  far: 120,
});
scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x90a4ae, 1.4));

const ground = new THREE.Mesh(new THREE.PlaneGeometry(80, 48), new THREE.MeshLambertMaterial({ color: 0xf5f5f0 }));
ground.receiveShadow = true;
scene.add(ground);
for (const { x, y, width, depth, height } of kHouses) {
  const house = new THREE.Mesh(
    new THREE.BoxGeometry(width, depth, height),
    new THREE.MeshLambertMaterial({ color: 0xb0a79a }),
  );
  house.position.set(x, y, height / 2);
  house.castShadow = house.receiveShadow = true;
  scene.add(house);
}

// One capsule for each character; it stands along z, with a nose in its heading.
const capsule = new THREE.CapsuleGeometry(0.28, 1.1, 4, 12).rotateX(Math.PI / 2).translate(0, 0, 0.83);
const people = new THREE.InstancedMesh(capsule, new THREE.MeshLambertMaterial(), crowd.count);
people.castShadow = true;
people.frustumCulled = false;
crowd.groups.forEach((group, k) => people.setColorAt(k, kColours[group]));
const nose = new THREE.SphereGeometry(0.12, 8, 6).translate(0.28, 0, 1.45);
const noses = new THREE.InstancedMesh(nose, new THREE.MeshLambertMaterial({ color: 0xf3c9a5 }), crowd.count);
noses.frustumCulled = false;
scene.add(people, noses);

const matrix = new THREE.Matrix4();
function place(share) {
  const { position, heading } = crowd.world.characters();
  for (let k = 0; k < crowd.count; k += 1) {
    const [x, y] = [2 * k, 2 * k + 1].map((at) => crowd.before[at] + share * (position[at] - crowd.before[at]));
    matrix.makeRotationZ(Math.atan2(heading[2 * k + 1], heading[2 * k])).setPosition(x, y, 0);
    people.setMatrixAt(k, matrix);
    noses.setMatrixAt(k, matrix);
  }
  people.instanceMatrix.needsUpdate = noses.instanceMatrix.needsUpdate = true;
}

function fit() {
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}

const ray = new THREE.Raycaster();
renderer.domElement.addEventListener('pointerdown', ({ clientX, clientY }) => {
  ray.setFromCamera(new THREE.Vector2((2 * clientX) / innerWidth - 1, 1 - (2 * clientY) / innerHeight), camera);
  const [hit] = ray.intersectObject(ground);
  if (hit) crowd.send({ x: hit.point.x, y: hit.point.y });
});
addEventListener('resize', fit);
fit();

let last = performance.now();
renderer.setAnimationLoop((now) => {
  place(crowd.advance(Math.max(0, now - last) / 1000));
  last = now;
  renderer.render(scene, camera);
  const { meanLag } = crowd.world.group(0);
  line.textContent = `Click to send the blue company. Step ${crowd.world.stepCount()}, ${meanLag.toFixed(2)} m from its places.`;
});
