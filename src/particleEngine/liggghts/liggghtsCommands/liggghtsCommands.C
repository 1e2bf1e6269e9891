/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liggghtsCommands.H"
#include "engineText.H"
#include "liggghtsTimeStep.H"
#include "OFstream.H"
#include "Pstream.H"
#include "userEntry.H"

#include <fstream>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::word;

typedef std::map<std::string, std::string> nameTable;

// Our words and the engine's
const nameTable normalNames{{"Hertz", "hertz"}, {"Hooke", "hooke"}};

const nameTable tangentialNames
{
    {"history", "history"}, {"noHistory", "no_history"}, {"none", "off"}
};

const nameTable rollingNames
{
    {"none", "off"}, {"cdt", "cdt"}, {"epsd", "epsd"}, {"epsd2", "epsd2"}
};

const nameTable cohesionNames{{"none", "off"}, {"area", "sjkr"}};


word choice
(
    const Foam::dictionary& dict,
    const word& key,
    const word& deflt,
    const nameTable& table
)
{
    const word name(dict.getOrDefault<word>(key, deflt));

    if (table.find(name) == table.end())
    {
        std::string valid;
        for (const auto& entry : table)
        {
            valid += ' ' + entry.first;
        }

        FatalIOErrorInFunction(dict)
            << "Unknown " << key << " contact model " << name << "\n\n"
            << "Valid " << key << " contact models:" << valid.c_str()
            << exit(Foam::FatalIOError);
    }

    return name;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liggghtsCommands::liggghtsCommands
(
    const dictionary& dict,
    const materials& mats,
    const bool heat,
    const bool overdamped
)
:
    dict_(dict),
    contacts_(userEntry::optionalDict(dict, "contacts")),
    materials_(mats),
    heat_(heat),
    overdamped_(overdamped),
    normal_(choice(contacts_, "normal", "Hertz", normalNames)),
    tangential_(choice(contacts_, "tangential", "history", tangentialNames)),
    rolling_(choice(contacts_, "rolling", "none", rollingNames)),
    cohesion_(choice(contacts_, "cohesion", "none", cohesionNames))
{
    for (const entry& e : contacts_)
    {
        static const wordList known
        {
            "normal", "tangential", "rolling", "cohesion",
            "characteristicVelocity"
        };

        if (!e.isDict() && !known.found(e.keyword()))
        {
            FatalIOErrorInFunction(contacts_)
                << "Unknown entry '" << e.keyword() << "' in "
                << contacts_.dictName() << nl
                << "Valid entries: " << flatOutput(known)
                << " and sub-dictionaries of pairs"
                << exit(FatalIOError);
        }
        if (e.isDict())
        {
            userEntry::onlyThese
            (
                e.dict(),
                {
                    "restitution", "friction", "rollingFriction",
                    "rollingDamping", "cohesionEnergyDensity"
                }
            );
        }
    }

    if
    (
        overdamped_
     && (tangential_ == "noHistory" || rolling_ == "cdt" || rolling_ == "epsd")
    )
    {
        FatalIOErrorInFunction(contacts_)
            << "Contacts in overdamped dynamics have no dashpots, but "
            << (tangential_ == "noHistory" ? "tangential " : "rolling ")
            << (tangential_ == "noHistory" ? tangential_ : rolling_)
            << " in " << contacts_.dictName() << " is one" << nl
            << "Use tangential history or none, and rolling none or epsd2"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liggghtsCommands::perMaterial
(
    const std::string& name,
    const scalarField& values
)
{
    std::string line("fix " + name + " all property/global " + name
      + " peratomtype");

    for (const scalar value : values)
    {
        line += ' ' + engineText(value);
    }
    add(line);
}


void Foam::dew::liggghtsCommands::perPair
(
    const std::string& name,
    const word& key,
    const dimensionSet& dims,
    const scalar above,
    const scalar high,
    const scalar unit
)
{
    const label n = materials_.size();
    std::string line("fix " + name + " all property/global " + name
      + " peratomtypepair " + std::to_string(n));

    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < n; j++)
        {
            line += ' ' + engineText
            (
                materials_.pair(key, dims, i, j, above, high)/unit
            );
        }
    }
    add(line);
}


Foam::scalar Foam::dew::liggghtsCommands::hookeStiffnessOf
(
    const label i,
    const label j,
    const scalar R
) const
{
    const scalar v = userEntry::positive
    (
        contacts_, "characteristicVelocity", dimVelocity
    );
    const scalar meff =
        0.5*materials_.density(i)*4.0/3.0*constant::mathematical::pi*pow3(R);

    return hookeStiffness(0.5*R, meff, materials_.effectiveModulus(i, j), v);
}


std::string Foam::dew::liggghtsCommands::model() const
{
    // The engine insists on this order
    return
        "model " + normalNames.at(normal_)
      + " tangential " + tangentialNames.at(tangential_)
      + (cohesion_ != "none" ? " cohesion " + cohesionNames.at(cohesion_) : "")
      + (rolling_ != "none" ? " rolling_friction " + rollingNames.at(rolling_) : "");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liggghtsCommands::stableTimeStep
(
    const label i,
    const scalar R
) const
{
    // Ten times the step recommended at a fraction of 0.1
    return normal_ == "Hooke" ? 12.5*timeStep(i, R, 0.1) : timeStep(i, R, 1);
}


Foam::scalar Foam::dew::liggghtsCommands::timeStep
(
    const label i,
    const scalar R,
    const scalar fraction
) const
{
    const scalar rho = materials_.density(i);

    if (normal_ == "Hooke")
    {
        const scalar meff =
            0.5*rho*4.0/3.0*constant::mathematical::pi*pow3(R);

        // The stiffest partner, particle or wall
        scalar least = GREAT;
        for (label j = 0; j < materials_.size(); j++)
        {
            least = min(least, hookeTime(meff, hookeStiffnessOf(i, j, R)));
        }
        return fraction/0.1*least/50;
    }

    return fraction*rayleighTime
    (
        R, rho, materials_.shearModulus(i), materials_.poissonsRatio(i)
    );
}


Foam::scalar Foam::dew::liggghtsCommands::overdampedTimeStep
(
    const label i,
    const scalar R,
    const scalar mu
) const
{
    scalar least = GREAT;
    for (label j = 0; j < materials_.size(); j++)
    {
        const scalar k =
            normal_ == "Hooke"
          ? hookeStiffnessOf(i, j, R)
          : hertzStiffness(R, materials_.effectiveModulus(i, j));
        least = min(least, overdampedTime(R, mu, k));
    }

    return least;
}


void Foam::dew::liggghtsCommands::begin(const vector& g)
{
    add("units lj");
    add("atom_style granular");
    add("atom_modify map hash");
    add("newton off");
    add("communicate single vel yes");

    if (dict_.found("processors"))
    {
        const Vector<label> n(dict_.get<Vector<label>>("processors"));
        add
        (
            "processors " + std::to_string(n.x()) + ' '
          + std::to_string(n.y()) + ' ' + std::to_string(n.z())
        );
    }
    else if (mag(g) > 0)
    {
        // Particles lie at the bottom: cut the box into columns
        const vector a(cmptMag(g));
        add
        (
            a.x() >= max(a.y(), a.z()) ? "processors 1 * *"
          : a.y() >= a.z() ? "processors * 1 *"
          : "processors * * 1"
        );
    }
}


void Foam::dew::liggghtsCommands::box
(
    const particleBox& pb,
    const boundBox& wide,
    const label nTypes
)
{
    std::string boundary("boundary"), region("region box block");

    for (direction k = 0; k < 3; k++)
    {
        boundary += pb.periodic(k) ? " p" : " f";
        region +=
            ' ' + engineText(wide.min()[k]/units_.length)
          + ' ' + engineText(wide.max()[k]/units_.length);
    }

    add(boundary);
    add(region + " units box");
    add("create_box " + std::to_string(nTypes) + " box");
}


void Foam::dew::liggghtsCommands::readRestart(const fileName& file)
{
    add("read_restart \"" + file + '"');
}


void Foam::dew::liggghtsCommands::contact(const scalar skin)
{
    add("neighbor " + engineText(skin/units_.length) + " bin");
    add("neigh_modify delay 0 every 1 check yes");

    scalarField E(materials_.size()), nu(E.size()), k(E.size()), cp(E.size());
    forAll(E, i)
    {
        E[i] = materials_.youngsModulus(i)/units_.pressure();
        nu[i] = materials_.poissonsRatio(i);
        k[i] = materials_.thermalConductivity(i)/(units_.power()/units_.length);
        cp[i] = materials_.heatCapacity(i)/sqr(units_.velocity());
    }

    perMaterial("youngsModulus", E);
    perMaterial("poissonsRatio", nu);
    if (heat_)
    {
        perMaterial("thermalConductivity", k);
        perMaterial("thermalCapacity", cp);
    }

    if (overdamped_)
    {
        const label n = materials_.size();
        std::string line
        (
            "fix coefficientRestitution all property/global"
            " coefficientRestitution peratomtypepair " + std::to_string(n)
        );
        for (label k = 0; k < n*n; k++)
        {
            line += " 1";
        }
        add(line);
    }
    else
    {
        perPair("coefficientRestitution", "restitution", dimless, 0.05, 1, 1);
    }

    if (tangential_ != "none")
    {
        perPair("coefficientFriction", "friction", dimless, -1, GREAT, 1);
    }
    if (rolling_ != "none")
    {
        perPair
        (
            "coefficientRollingFriction", "rollingFriction", dimless, -1,
            GREAT, 1
        );
    }
    if (rolling_ == "epsd")
    {
        perPair
        (
            "coefficientRollingViscousDamping", "rollingDamping", dimless,
            -1, GREAT, 1
        );
    }
    if (cohesion_ != "none")
    {
        perPair
        (
            "cohesionEnergyDensity", "cohesionEnergyDensity", dimPressure,
            -1, GREAT, units_.pressure()
        );
    }
    if (normal_ == "Hooke")
    {
        add
        (
            "fix characteristicVelocity all property/global"
            " characteristicVelocity scalar "
          + engineText
            (
                userEntry::positive
                (
                    contacts_, "characteristicVelocity", dimVelocity
                )/units_.velocity()
            )
        );
    }

    add("pair_style gran " + model());
    add("pair_coeff * *");
}


void Foam::dew::liggghtsCommands::temperature
(
    const std::string& fix,
    const particleWall& w
)
{
    if (heat_ && w.heated())
    {
        wallTemperatures_ += ' ' + fix + ' ' + engineText(w.T());
    }
}


void Foam::dew::liggghtsCommands::wallOf
(
    const particleWall& w,
    const word& part,
    const wallShape& shape,
    const fileName& stlPath
)
{
    const std::string name("wall_" + part);
    const std::string type(std::to_string(w.material() + 1));
    const std::string axis(1, "xyz"[shape.axis]);
    const point p(shape.position/units_.length);

    std::string line("fix " + name + " all wall/gran " + model());
    if (shape.what == wallShape::plane)
    {
        add
        (
            line + " primitive type " + type + ' ' + axis + "plane "
          + engineText(p[shape.axis])
        );
        temperature(name, w);
        return;
    }

    if (shape.what == wallShape::cylinder)
    {
        const label k1 = (shape.axis + 1)%3, k2 = (shape.axis + 2)%3;
        add
        (
            line + " primitive type " + type + ' ' + axis + "cylinder "
          + engineText(shape.radius/units_.length) + ' '
          + engineText(p[min(k1, k2)]) + ' ' + engineText(p[max(k1, k2)])
        );
        temperature(name, w);
        return;
    }

    if (Pstream::master())
    {
        std::ofstream os(stlPath);
        os << "solid " << part << '\n';

        for (label i = 0; i < shape.corners.size(); i += 3)
        {
            const point& a = shape.corners[i];
            const point& b = shape.corners[i + 1];
            const point& c = shape.corners[i + 2];
            vector n((b - a) ^ (c - a));
            n /= mag(n) + ROOTVSMALL*ROOTVSMALL;

            os << "facet normal " << engineText(n) << "\n outer loop\n";
            for (label k = 0; k < 3; k++)
            {
                os << "  vertex "
                    << engineText(shape.corners[i + k]/units_.length) << '\n';
            }
            os << " endloop\nendfacet\n";
        }
        os << "endsolid " << part << '\n';
    }

    const std::string mesh("mesh_" + part);
    add
    (
        "fix " + mesh + " all mesh/surface file \"" + stlPath + "\" type "
      + type + " curvature_tolerant yes"
    );
    meshes_.append(mesh);
    temperature(mesh, w);

    if (w.motion().moves())
    {
        add
        (
            "fix move_" + part + " all move/mesh mesh " + mesh + ' '
          + w.motion().engineArguments(units_)
        );
    }
}


void Foam::dew::liggghtsCommands::meshWalls()
{
    if (meshes_.empty())
    {
        return;
    }

    // The engine wants one fix for all of them
    std::string line
    (
        "fix walls all wall/gran " + model() + " mesh n_meshes "
      + std::to_string(meshes_.size()) + " meshes"
    );
    for (const std::string& mesh : meshes_)
    {
        line += ' ' + mesh;
    }
    add(line);
}


void Foam::dew::liggghtsCommands::wallContacts()
{
    add("fix wallContacts all dew/wallContacts" + wallTemperatures_);
}


void Foam::dew::liggghtsCommands::conduction
(
    const scalar T0,
    const conductionModel& model
)
{
    // The temperature is integrated with the bulk heat, by our integrator
    add
    (
        "fix ste_heattransfer all transportequation/scalar"
        " equation_id heattransfer quantity Temp default_value "
      + engineText(T0)
      + " flux_quantity heatFlux source_quantity heatSource"
        " capacity_quantity thermalCapacity"
    );
    add("fix_modify ste_heattransfer integrate stop");

    if (model.type() == "none")
    {
        return;
    }

    const scalar perLength = units_.power()/units_.length;
    std::string line
    (
        "fix conduction all dew/conduction " + model.type() + ' '
      + engineText(model.fluidConductivity()/perLength)
    );

    for (label i = 0; i < materials_.size(); i++)
    {
        const scalar rhoCp =
            materials_.density(i)*materials_.heatCapacity(i);
        const scalar compliance =
            (1 - sqr(materials_.poissonsRatio(i)))
           /materials_.youngsModulus(i);

        line +=
            ' ' + engineText(materials_.thermalConductivity(i)/perLength)
          + ' ' + engineText(rhoCp/units_.pressure())
          + ' ' + engineText(compliance*units_.pressure());
    }
    add(line);
}


void Foam::dew::liggghtsCommands::listReach
(
    const scalar reach,
    const scalar margin,
    const scalar factor
)
{
    add
    (
        "fix listReach all dew/listReach "
      + engineText(reach/units_.length) + ' '
      + engineText(margin/units_.length) + ' ' + engineText(factor)
    );
}


void Foam::dew::liggghtsCommands::colloids()
{
    add("fix colloids all dew/colloidPairs");
}


void Foam::dew::liggghtsCommands::dissipative
(
    const dissipativeForces& forces,
    const label seed
)
{
    add
    (
        "fix dissipative all dew/dissipativePairs " + std::to_string(seed)
      + ' ' + forces.engineArguments(units_)
    );
}


void Foam::dew::liggghtsCommands::immersion(const immersionForces& forces)
{
    add("fix immersion all dew/immersion " + forces.engineArguments(units_));
}


void Foam::dew::liggghtsCommands::lubrication(const lubricationProperties& l)
{
    if (l.on())
    {
        add("fix lubrication all dew/lubrication " + l.engineArguments(units_));
    }
}


void Foam::dew::liggghtsCommands::integrator()
{
    add
    (
        std::string("fix integrate all dew/integrate")
      + (overdamped_ ? " overdamped" : "")
    );
}


void Foam::dew::liggghtsCommands::end(const scalar deltaT)
{
    add("timestep " + engineText(deltaT/units_.time));
    add("fix gravity all dew/gravity");
    add("thermo 0");
    add("thermo_modify lost ignore norm no");
}


void Foam::dew::liggghtsCommands::native(const UList<string>& own)
{
    for (const string& line : own)
    {
        add(line);
    }
}
