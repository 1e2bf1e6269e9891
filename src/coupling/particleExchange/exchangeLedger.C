/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "exchangeLedger.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"

#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::exchangeLedger::exchangeLedger
(
    const Time& time,
    const bool wedge
)
:
    time_(time),
    wedge_(wedge)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::exchangeLedger::mostClipped(const scalar volume)
{
    const scalar most = returnReduce(volume, maxOp<scalar>());
    if (most <= 0)
    {
        return;
    }

    const label me = Pstream::myProcNo();
    const label rank =
        returnReduce(volume == most ? me : labelMax, minOp<label>());

    if (rank != me)
    {
        clippedCell = 0;
        clippedAt = Zero;
        clippedAlphac = 0;
    }
    reduce(clippedCell, sumOp<label>());
    reduce(clippedAt, sumOp<vector>());
    reduce(clippedAlphac, sumOp<scalar>());
}


void Foam::dew::exchangeLedger::print() const
{
    const auto digits = [](const scalar value)
    {
        std::ostringstream os;
        os.precision(4);
        os << value;
        return string(os.str());
    };
    const auto relative = [&](const scalar difference, const scalar whole)
    {
        return digits(whole > 0 ? difference/whole : 0);
    };

    Info<< "Exchange: volume " << digits(held).c_str()
        << " m3, momentum to particles "
        << (wedge_ ? "(radial azimuthal axial) " : "") << '(' << digits(received.x()).c_str()
        << ' ' << digits(received.y()).c_str() << ' '
        << digits(received.z()).c_str() << ") N s, unbalanced "
        << relative(mag(received - lost), scale).c_str();

    if (thermal)
    {
        Info<< ", heat " << digits(heatReceived).c_str()
            << " J, unbalanced "
            << relative(mag(heatReceived - heatLost), heatScale).c_str();
    }
    Info<< endl;

    for (const amounts& s : scalars)
    {
        Info<< "    " << s.name << ": in particles " << digits(s.held).c_str()
            << ", to particles " << digits(s.received).c_str()
            << ", unbalanced "
            << relative(mag(s.received - s.lost), s.scale).c_str() << endl;
    }

    if (clipped > 0)
    {
        Info<< "    clipped by alphacMin: " << digits(clipped).c_str()
            << " m3 of particles (" << relative(clipped, held).c_str()
            << " of all); most in cell " << clippedCell << " at "
            << clippedAt << ", alphac " << digits(clippedAlphac).c_str()
            << endl;
    }
    if (delayed)
    {
        Info<< "    lagging, not yet in alphac: " << digits(lagging).c_str()
            << " m3 of particles (" << relative(lagging, held).c_str()
            << " of all)" << endl;
    }
    if (outside)
    {
        Info<< "    outside the mesh, without fluid: " << outside
            << " particles" << endl;
    }
}


void Foam::dew::exchangeLedger::write()
{
    if (Pstream::master() && !file_)
    {
        // Here, not before: a dry run leaves an earlier file alone
        const fileName folder
        (
            time_.globalPath()/"postProcessing"/"exchange"
           /time_.timeName(time_.startTime().value())
        );
        mkDir(folder);
        file_.reset(new OFstream(folder/"ledger.dat"));
        file_().precision(17);
        file_()
            << "# time held represented clipped outside "
            << (
                   wedge_
                 ? "received.radial received.azimuthal received.axial"
                   " lost.radial lost.azimuthal lost.axial"
                 : "received.x received.y received.z lost.x lost.y lost.z"
               )
            << " scale"
            << " heatReceived heatLost heatScale lagging";
        for (const amounts& s : scalars)
        {
            file_()
                << ' ' << s.name << ".held " << s.name << ".received "
                << s.name << ".lost " << s.name << ".scale";
        }
        file_() << endl;
    }
    if (file_)
    {
        OFstream& os = file_();
        os  << time_.value() << ' ' << held << ' ' << represented << ' '
            << clipped << ' ' << outside << ' '
            << received.x() << ' ' << received.y() << ' ' << received.z()
            << ' ' << lost.x() << ' ' << lost.y() << ' ' << lost.z() << ' '
            << scale << ' ' << heatReceived << ' ' << heatLost << ' '
            << heatScale << ' ' << lagging;
        for (const amounts& s : scalars)
        {
            os  << ' ' << s.held << ' ' << s.received << ' ' << s.lost << ' '
                << s.scale;
        }
        os << nl;
        os.flush();
    }
}
