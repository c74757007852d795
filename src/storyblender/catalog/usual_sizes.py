"""How large things usually are that have a name but no entry among the props, for models from outside. Data."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props.phrases import before_details
from storyblender.catalog.props.prop_names import prop_called
from storyblender.memory.base import Vec3

_SIZES = """
forklift 1.2 2.6 2.2; lorry 2.5 8 3.5; semi truck 2.5 16 4; sedan 1.8 4.6 1.5; suv 1.9 4.7 1.75; coupe 1.8 4.4 1.35;
smart car 1.6 2.6 1.5; scooter 0.7 1.8 1.1; kick scooter 0.5 1 1; tricycle 0.5 0.8 0.7; stroller 0.5 0.9 1; caravan 2.3 6 2.6;
trailer 2.2 5 2.5; tram 2.5 25 3.5; coach 2.5 11 3.4; escalator 1.5 9 4.5; elevator 1.6 1.6 2.3; staircase 1 3 2.8;
stairs 1 3 2.8; spiral staircase 1.8 1.8 2.8; stepladder 0.5 0.9 1.6; pool 5 10 1.6; swimming pool 5 10 1.6; hot tub 2 2 0.9;
trampoline 3 3 0.9; slide 0.6 3 1.8; seesaw 0.4 2.8 0.8; playground 5 5 3; football goal 7.3 2 2.4; basketball hoop 1.8 1.2 3.9;
ping pong table 1.5 2.7 0.76; column 0.4 0.4 2.8; pillar 0.4 0.4 2.8; fence 2 0.1 1.2; hedge 2 0.6 1.4; pergola 3 3 2.4;
gazebo 3 3 3; shed 2.5 2 2.3; hut 2.5 2 2.3; dog house 0.7 0.9 0.75; greenhouse 2.5 3 2.3; garage 3.5 6 2.8; barn 10 15 8;
crossing 4 6 0.02; parking space 2.5 5 0.02; manhole 0.7 0.7 0.05; bus stop 4 1.6 2.6; bench press 1.3 1.5 1.3;
treadmill 0.8 1.8 1.4; exercise bike 0.55 1.1 1.3; punching bag 0.35 0.35 1.2; yoga mat 0.6 1.8 0.01;
sleeping bag 0.8 2 0.12; hammock 1 3 1.1; lounger 0.7 2 0.4; sun lounger 0.7 2 0.4; chaise longue 0.7 1.7 0.8; bean bag 0.9 0.9 0.8;
pouf 0.5 0.5 0.4; ottoman 0.7 0.5 0.42; footstool 0.45 0.35 0.38; high chair 0.55 0.6 0.95; children chair 0.32 0.34 0.58;
children table 0.7 0.5 0.5; kids desk 0.9 0.55 0.6; cot 0.7 1.3 0.9; crib 0.7 1.3 0.9; baby bed 0.7 1.3 0.9; changing table 0.8 0.55 0.95;
single bed 0.95 2.05 0.8; double bed 1.6 2.1 1; bar table 0.7 0.7 1.05; pedestal table 0.8 0.8 0.75; console table 1.2 0.4 0.8;
console 1.2 0.4 0.8; tv stand 1.6 0.45 0.5; sideboard 1.6 0.45 0.8; buffet 1.6 0.45 0.9; hutch 1.1 0.45 1.9; credenza 1.6 0.45 0.75;
bar 1.8 0.6 1.1; shelf 0.8 0.25 0.25; wine rack 0.6 0.3 0.8; shoe rack 0.8 0.3 0.6; coat rack 0.5 0.5 1.75; coat stand 0.5 0.5 1.75;
clothes rack 1.1 0.45 1.5; towel rack 0.6 0.1 0.3; high cabinet 0.6 0.6 2.1; upper cabinet 0.6 0.35 0.7; wall cabinet 0.6 0.35 0.7;
kitchen cabinet 0.6 0.6 0.88; lower cabinet 0.6 0.6 0.88; sink cabinet 0.8 0.6 0.9; vanity 0.9 0.5 0.85; kitchen island 1.5 0.9 0.9;
kitchen 3 0.65 2.2; dishwasher 0.6 0.6 0.85; tumble dryer 0.6 0.6 0.85; freezer 0.6 0.65 1.6; chest freezer 1.1 0.65 0.85;
oven 0.6 0.6 0.6; hob 0.6 0.52 0.06; cooktop 0.6 0.52 0.06; cooker 0.6 0.6 0.9; extractor hood 0.6 0.5 0.6; hood 0.6 0.5 0.6;
kettle 0.2 0.16 0.24; blender 0.18 0.18 0.4; mixer 0.25 0.35 0.35; rice cooker 0.28 0.28 0.25; food processor 0.22 0.25 0.4;
washbasin 0.6 0.48 0.85; basin 0.55 0.42 0.18; shower 0.9 0.9 2.1; shower cabin 0.9 0.9 2.1; bidet 0.38 0.58 0.42; urinal 0.35 0.35 0.65;
faucet 0.15 0.2 0.2; tap 0.15 0.2 0.2; soap dispenser 0.08 0.1 0.18; bathroom cabinet 0.6 0.2 0.7; water heater 0.45 0.45 0.8;
air conditioner 0.85 0.22 0.3; fan 0.45 0.4 1.2; heater 0.6 0.2 0.5; dehumidifier 0.35 0.25 0.6; iron 0.12 0.28 0.15;
plant 0.5 0.5 0.8; flowers 0.25 0.25 0.35; orchid 0.25 0.25 0.5; bonsai 0.4 0.35 0.4; bonsai tree 0.4 0.35 0.4; fern 0.7 0.7 0.6; ivy 0.6 0.4 0.6;
succulent 0.16 0.16 0.16; bamboo 1 1 3; bamboo plant 0.6 0.6 1.6; shrub 1 1 1; oak 8 8 11; birch 5 5 11; willow 8 8 9; fir 4 4 9; spruce 4 4 10;
cypress 1.6 1.6 7; poplar 3 3 14; maple 7 7 10; cherry tree 5 5 5; apple tree 5 5 5; olive tree 4 4 5; fruit tree 4 4 4.5;
acacia 6 6 7; banana tree 2.5 2.5 3; coconut tree 5 5 10; flower box 0.8 0.25 0.4; planter 0.6 0.4 0.5; flower pot 0.3 0.3 0.28;
rose 0.12 0.12 0.45; tulip 0.1 0.1 0.4; grass 0.5 0.5 0.25; mushroom 0.08 0.08 0.1; lamp 0.35 0.35 0.55; light 0.35 0.35 0.4;
floor light 0.4 0.4 1.6; desk lamp 0.25 0.4 0.5; bedside lamp 0.25 0.25 0.42; ceiling lamp 0.45 0.45 0.25; ceiling light 0.45 0.45 0.15;
hanging lamp 0.4 0.4 0.8; spotlight 0.15 0.2 0.2; track light 1.2 0.15 0.2; wall light 0.2 0.2 0.3; street lamp 0.6 0.6 4.5;
street light 0.8 1.5 6; fluorescent 1.2 0.15 0.1; neon tube 1.2 0.05 0.05; garden light 0.2 0.2 0.6; outdoor lamp 0.3 0.3 0.6;
chandelier lamp 0.8 0.8 0.9; sconce 0.2 0.2 0.35; projector 0.35 0.3 0.14; projector screen 2 0.1 1.6; monitor 0.55 0.2 0.45;
screen 0.9 0.15 0.6; imac 0.54 0.2 0.5; mac 0.5 0.3 0.45; server 0.6 1 2; router 0.25 0.18 0.05; modem 0.2 0.15 0.05;
scanner 0.3 0.45 0.1; photocopier 0.65 0.7 1.1; copier 0.65 0.7 1.1; fax 0.35 0.35 0.2; mouse pad 0.25 0.2 0.004; webcam 0.08 0.05 0.05;
dvd player 0.43 0.28 0.06; game console 0.3 0.25 0.08; amplifier 0.43 0.35 0.15; stereo 0.4 0.3 0.3; hifi 0.45 0.35 0.4; turntable 0.43 0.35 0.14;
jukebox 0.8 0.6 1.5; subwoofer 0.35 0.35 0.4; synthesizer 1 0.35 0.12; keyboard instrument 1.3 0.35 0.14; cello 0.45 0.3 1.25; double bass 0.65 0.45 1.8;
organ 1.4 0.8 1.2; tuba 0.5 0.4 1; banjo 0.33 0.12 0.95; music stand 0.5 0.4 1.2; xylophone 0.9 0.4 0.15; bongo 0.4 0.25 0.25;
garage door 2.6 0.15 2.2; double door 1.6 0.12 2.1; sliding door 1.8 0.12 2.1; french window 1.4 0.15 2.1; shutter 0.7 0.06 1.3; blind 1 0.06 1.3;
door frame 0.95 0.15 2.1; elevator door 1 0.15 2.1; skylight 0.8 1.2 0.15; stained glass 0.8 0.05 1.2; parcel 0.4 0.3 0.25; pallet 0.8 1.2 0.15;
container 2.4 6 2.6; box 0.45 0.35 0.3; case 0.6 0.4 0.25; trunk 0.9 0.5 0.5; can 0.07 0.07 0.12; pitcher 0.15 0.12 0.25; tin 0.08 0.08 0.11;
spatula 0.08 0.32 0.03; whisk 0.07 0.3 0.07; colander 0.28 0.28 0.13; grater 0.1 0.08 0.23; cleaver 0.1 0.32 0.02; pepper mill 0.06 0.06 0.2;
salt shaker 0.05 0.05 0.09; wok 0.5 0.35 0.12; bottle opener 0.04 0.15 0.02; corkscrew 0.08 0.03 0.16; napkin 0.2 0.2 0.01; tablecloth 1.8 1.2 0.5;
vending machine 0.95 0.8 1.85; atm 0.5 0.6 1.5; arcade machine 0.7 0.85 1.75; pinball 0.7 1.4 1.8; foosball table 0.8 1.5 0.9; pool table 1.4 2.5 0.82;
chess set 0.4 0.4 0.1; mannequin 0.5 0.35 1.75; person 0.55 0.35 1.72; man 0.55 0.35 1.76; woman 0.5 0.33 1.65; child 0.4 0.28 1.2; baby 0.25 0.2 0.6;
chicken 0.25 0.4 0.4; sheepdog 0.25 0.9 0.65; pony 0.5 1.8 1.4; puppy 0.18 0.4 0.3; kitten 0.12 0.3 0.2; bull 0.8 2.5 1.5; calf 0.4 1.3 1;
statue bust 0.4 0.3 0.6; bust 0.4 0.3 0.6; sculpture 0.4 0.4 0.7; figurine 0.1 0.1 0.2; fountain pen 0.014 0.014 0.14; pencil 0.008 0.18 0.008;
notebook 0.21 0.15 0.015; eraser 0.05 0.02 0.013; calculator 0.08 0.15 0.02; phone 0.2 0.2 0.12; mobile phone 0.07 0.15 0.009; iphone 0.07 0.15 0.008;
headphones 0.18 0.09 0.2; sunglasses 0.15 0.15 0.05; handbag 0.35 0.15 0.3; purse 0.25 0.1 0.18; bracelet 0.07 0.07 0.02; earring 0.02 0.01 0.04;
shirt 0.5 0.25 0.75; t shirt 0.5 0.25 0.7; trousers 0.4 0.25 1; jacket 0.55 0.3 0.75; coat 0.55 0.3 1.1; dress 0.5 0.3 1.1; skirt 0.4 0.3 0.55;
cap 0.2 0.28 0.14; scarf 0.2 1.6 0.02; slipper 0.1 0.27 0.09; boot 0.11 0.3 0.35; barstool 0.42 0.42 0.76; mixing desk 1 0.6 0.15;
catapult 2 4 2.5; cannonball 0.15 0.15 0.15; windmill 9 9 16; tower 7 7 22; castle 40 40 25; church 14 28 24; skyscraper 35 35 150;
bridge 6 30 6; pier 4 25 3; canoe 0.85 4.8 0.4; kayak 0.65 4 0.35; yacht 4 14 12; ship 16 90 25; submarine 9 70 12; motorboat 2.2 6 1.8; raft 2 2.5 0.4;
jet ski 1.1 3 1.1; quad 1.1 1.9 1.1; go kart 1.3 1.9 0.6; golf cart 1.2 2.4 1.8; bulldozer 3 5.5 3.1; crane 4 12 12; mixer truck 2.5 8.5 3.7;
train 3 20 4; wagon 2.8 12 3.8; drone 0.35 0.35 0.12; glider 15 7 1.9; biplane 9 7 2.8; hot air balloon 16 16 22; airship 20 60 20;
moped 0.7 1.75 1.05; segway 0.65 0.5 1.3; carriage 1.8 3.5 2.2; chariot 1.6 2.6 1.4; bath 0.75 1.7 0.58; trashcan 0.45 0.45 0.8; waste bin 0.35 0.35 0.5;
litter bin 0.45 0.45 0.9; lamp post 0.4 0.4 4; washstand 0.7 0.45 0.8; lavatory 0.5 0.45 0.85; keg 0.4 0.4 0.55; cask 0.6 0.6 0.8
"""


@cache
def _sizes() -> dict[tuple[str, ...], Vec3]:
    found: dict[tuple[str, ...], Vec3] = {}
    for line in _SIZES.replace("\n", " ").split(";"):
        *words, width, depth, height = line.split()
        found[tuple(noun_key(word) for word in words)] = (float(width), float(depth), float(height))
    return found


def usual_size(words: Sequence[str]) -> Vec3 | None:
    """Return width, depth and height in metres of what the last words of a name mean; None if they mean nothing known.

    A prop of that very name counts before a shorter name here: a coffee table is no table.

    Args:
        words: Lower-case words of a name, the thing last, or before ``with``, ``of``, ``and``.
    """
    told = [noun_key(word) for word in before_details(list(words))]
    for start in range(len(told)):
        phrase = tuple(told[start:])
        if phrase in _sizes():
            return _sizes()[phrase]
        entry = prop_called(phrase)
        if entry is not None:
            return entry.size
    return None
