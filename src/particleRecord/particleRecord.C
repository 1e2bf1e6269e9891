/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleRecord.H"
#include "error.H"
#include "Map.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <zlib.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const char magic[16] = "dewParticles 1\n";

const std::streamoff headerBytes = sizeof(magic) + 2*sizeof(std::int64_t);
const std::streamoff tailBytes = sizeof(std::uint64_t);

//- Particles handed on at a time
const label chunk = 8192;

const UPstream::commsTypes scheduled = UPstream::commsTypes::scheduled;


std::streamoff rowBytes(const label nComponents)
{
    return sizeof(std::int64_t) + nComponents*sizeof(double);
}


//- CRC-32 of what was there, and this
void add(unsigned long& crc, const char* data, const std::streamoff bytes)
{
    crc = crc32(crc, reinterpret_cast<const Bytef*>(data), uInt(bytes));
}


//- Rows first to last, as they are in the file
void pack
(
    const labelUList& ids,
    const UList<scalar>& values,
    const label nComponents,
    const label first,
    const label n,
    List<char>& rows
)
{
    const std::streamoff row = rowBytes(nComponents);
    rows.setSize(n*row);

    for (label i = 0; i < n; i++)
    {
        char* to = rows.data() + i*row;
        const std::int64_t id = ids[first + i];
        std::memcpy(to, &id, sizeof(id));

        for (label k = 0; k < nComponents; k++)
        {
            const double value = values[(first + i)*nComponents + k];
            std::memcpy
            (
                to + sizeof(id) + k*sizeof(double), &value, sizeof(double)
            );
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleRecord::write
(
    const fileName& path,
    const labelUList& ids,
    const UList<scalar>& values,
    const label nComponents
)
{
    if (values.size() != ids.size()*nComponents)
    {
        FatalErrorInFunction
            << values.size() << " values for " << ids.size()
            << " particles with " << nComponents << " values each"
            << exit(FatalError);
    }

    labelList counts(Pstream::nProcs(), Zero);
    counts[Pstream::myProcNo()] = ids.size();
    Pstream::gatherList(counts);

    List<char> rows;

    if (!Pstream::master())
    {
        for (label first = 0; first < ids.size(); first += chunk)
        {
            const label n = min(chunk, ids.size() - first);
            pack(ids, values, nComponents, first, n, rows);
            UOPstream::write
            (
                scheduled, Pstream::masterNo(), rows.cdata(), rows.size()
            );
        }
        return;
    }

    std::ofstream os(path, std::ios::binary | std::ios::trunc);
    unsigned long crc = crc32(0, Z_NULL, 0);

    const auto put = [&](const void* data, const std::streamoff bytes)
    {
        os.write(static_cast<const char*>(data), bytes);
        add(crc, static_cast<const char*>(data), bytes);
    };

    std::int64_t header[2] = {0, nComponents};
    for (const label n : counts)
    {
        header[0] += n;
    }
    put(magic, sizeof(magic));
    put(header, sizeof(header));

    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        for (label first = 0; first < counts[rank]; first += chunk)
        {
            const label n = min(chunk, counts[rank] - first);

            if (rank == Pstream::myProcNo())
            {
                pack(ids, values, nComponents, first, n, rows);
            }
            else
            {
                rows.setSize(n*rowBytes(nComponents));
                UIPstream::read(scheduled, rank, rows.data(), rows.size());
            }
            put(rows.cdata(), rows.size());
        }
    }

    const std::uint64_t sum = crc;
    os.write(reinterpret_cast<const char*>(&sum), sizeof(sum));
    os.close();

    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write the file " << path << nl
            << "Look at its directory's permissions, and for space on the disk"
            << exit(FatalError);
    }
}


Foam::List<Foam::scalar> Foam::dew::particleRecord::read
(
    const fileName& path,
    const labelUList& ids,
    const label nComponents,
    boolList& found
)
{
    Map<label> index(2*ids.size());
    forAll(ids, i)
    {
        index.insert(ids[i], i);
    }

    List<scalar> values(ids.size()*nComponents, Zero);
    found.setSize(ids.size());
    found = false;

    const std::streamoff row = rowBytes(nComponents);
    std::ifstream is;
    std::int64_t header[2] = {0, 0};
    unsigned long crc = crc32(0, Z_NULL, 0);

    // Errors on the master only: they end the run on all ranks
    const auto damaged = [&](const string& what)
    {
        FatalErrorInFunction
            << "The file " << path << " of a restart is damaged: "
            << what.c_str() << nl
            << "Start from an earlier time, or from the beginning"
            << exit(FatalError);
    };

    if (Pstream::master())
    {
        is.open(path, std::ios::binary);
        if (!is)
        {
            FatalErrorInFunction
                << "No file " << path << ", which belongs to a restart" << nl
                << "Start from an earlier time, or from the beginning"
                << exit(FatalError);
        }

        is.seekg(0, std::ios::end);
        const std::streamoff length = is.tellg();
        is.seekg(0);

        char start[sizeof(magic)];
        is.read(start, sizeof(start));
        is.read(reinterpret_cast<char*>(header), sizeof(header));

        if (!is || std::memcmp(start, magic, sizeof(magic)) != 0)
        {
            damaged("its header is not that of a particle record");
        }
        if (header[1] != nComponents)
        {
            damaged
            (
                std::to_string(header[1]) + " values a particle instead of "
              + std::to_string(nComponents)
            );
        }
        if
        (
            header[0] < 0
         || header[0] > length/row
         || length != headerBytes + header[0]*row + tailBytes
        )
        {
            damaged
            (
                std::to_string(length) + " bytes, which is not the length of "
              + std::to_string(header[0]) + " particles"
            );
        }
        add(crc, start, sizeof(start));
        add(crc, reinterpret_cast<const char*>(header), sizeof(header));
    }

    label left = header[0];
    Pstream::scatter(left);

    List<char> rows;
    while (left > 0)
    {
        const label n = min(chunk, left);
        left -= n;

        if (Pstream::master())
        {
            rows.setSize(n*row);
            is.read(rows.data(), rows.size());
            add(crc, rows.cdata(), rows.size());
        }
        Pstream::scatter(rows);

        for (label i = 0; i < n; i++)
        {
            const char* from = rows.cdata() + i*row;
            std::int64_t id;
            std::memcpy(&id, from, sizeof(id));

            const auto mine = index.cfind(label(id));
            if (mine.found())
            {
                found[*mine] = true;
                for (label k = 0; k < nComponents; k++)
                {
                    double value;
                    std::memcpy
                    (
                        &value,
                        from + sizeof(id) + k*sizeof(double),
                        sizeof(double)
                    );
                    values[*mine*nComponents + k] = value;
                }
            }
        }
    }

    bool good = true;
    if (Pstream::master())
    {
        std::uint64_t sum = 0;
        is.read(reinterpret_cast<char*>(&sum), sizeof(sum));
        good = is && sum == crc;
        if (!good)
        {
            damaged("its checksum is wrong");
        }
    }

    // No rank goes on with values that are not
    Pstream::scatter(good);

    return values;
}
